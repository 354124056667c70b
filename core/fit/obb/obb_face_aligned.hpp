// The best oriented box that is flush with a face of the hull.
// Source: I. D. Romanick, "Data Structures & Algorithms for Geometry", 2007: a box flush with a face of the hull, on
// the least-area rectangle of the projection onto it. In the plane that is the smallest box (H. Freeman, R. Shapira,
// "Determining the minimum-area encasing rectangle for an arbitrary closed curve", 1975); in space it need not be.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "fit/obb/obb_hull.hpp"
#include "fit/obb/obb_hull_solid.hpp"
#include "fit/obb/obb_trials.hpp"
#include "geometry/orientation.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kObbFaceAlignedPseudocode{
    "hull ← convex hull of the points",
    "for each face of the hull (in 2-D: edge)",
    "  box ← on the face, with the smallest rectangle",
    "  if box is smaller than best: keep it",
    "extents ← least and greatest along each",
    "return box",
};

/// Tries the box on each face of a hull in space; if the hull is flat, the box on the hull itself.
template <class Scalar, class Observer>
class ObbFaceAligned {
 public:
  ObbFaceAligned(const ConvexHull<Scalar, 3>& hull, Observer& observe)
      : hull_(hull), observe_(observe), trials_(hull.vertices, observe) {}

  /// The best box's axes.
  Matrix<Scalar, 3> run() {
    switch (hull_.affine_dim) {
      case 0: attempt({Matrix<double, 3>::Identity()}, hull_.indices); break;
      case 1: attempt({frame(at(1) - at(0), Vector<double, 3>::Zero())}, hull_.indices); break;
      case 2: try_plane(); break;
      default: try_faces();
    }
    return trials_.scalar_axes();
  }

 private:
  using Point = Vector<double, 3>;
  using Triangle = std::array<Index, 3>;

  [[nodiscard]] const Point& at(Index i) const { return trials_.local().at[i]; }

  void try_plane() {
    const std::vector<Point>& vertices = trials_.local().at;
    attempt(watched_rectangle_along(watched_flat_normal(vertices, observe_), vertices, observe_), hull_.indices);
  }

  void try_faces() {
    PartCounterFor<Observer> built;
    const HullSolid solid(hull_, built);
    hand_on(built, observe_);
    for (std::size_t f = 0; f < hull_.facets.size(); ++f) {
      if (f > 0 && in_one_plane(hull_.facets[f - 1], hull_.facets[f])) continue;
      const Point& normal = solid.normals()[f];
      std::vector<Point> outline;
      PartCounterFor<Observer> walked;
      for (const Index i : solid.outline(normal, walked)) outline.push_back(at(i));
      hand_on(walked, observe_);
      std::array<Index, 3> face{};
      for (std::size_t k = 0; k < 3; ++k) face[k] = hull_.indices[hull_.facets[f][k]];
      attempt(watched_rectangle_along(normal, outline, observe_), face);
    }
  }

  /// Quickhull lists the triangles of one face one after the other.
  [[nodiscard]] bool in_one_plane(const Triangle& f, const Triangle& g) {
    const auto p = [&](Index i) -> Point { return hull_.vertices[i].template cast<double>(); };
    return std::all_of(g.begin(), g.end(), [&](Index i) {
      if (std::find(f.begin(), f.end(), i) != f.end()) return true;
      observe_.count(Operation::kOrientationTests, 1);
      return orient3d(p(f[0]), p(f[1]), p(f[2]), p(i)) == 0;
    });
  }

  template <class Indices>
  void attempt(const RectangleFrame<3>& rectangle, const Indices& on) {
    trials_.attempt_and_tell(rectangle.axes, [&](const Obb<Scalar, 3>& box, bool better) {
      observe_(ObbStep<Scalar, 3>{better ? 3 : 2, true, trials_.box(),
                                  BoxTried<Scalar, 3>{{on.begin(), on.end()}, box, measure(box), better}});
    });
  }

  const ConvexHull<Scalar, 3>& hull_;
  Observer& observe_;
  ObbTrials<Scalar, 3, Observer> trials_;
};

/// The smallest box with a side flush with a face of the hull; in 2-D with an edge, which makes it the smallest of all.
/// On a regular tetrahedron it is twice as large as the smallest.
/// points: n >= 1 finite points, scene units. Expected O(n log n) time for the hull; in 3-D O(h) more for each face of
/// a hull with h vertices.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_face_aligned(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  Matrix<Scalar, Dim> axes;
  if constexpr (Dim == 2)  // the calipers report their steps on lines 2 and 3
    axes = smallest_rectangle(hull, observe).axes.template cast<Scalar>();
  else axes = ObbFaceAligned<Scalar, std::remove_reference_t<Observer>>(hull, observe).run();
  return finish_on_hull<Scalar, Dim>(axes, hull, 4, observe);
}

}  // namespace snug::fit
