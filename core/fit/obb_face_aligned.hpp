// Source: I. D. Romanick, "Data Structures & Algorithms for Geometry", 2007: a box with one side on a face of the hull, and the
// rectangle of least area across it. In the plane that is the smallest box (H. Freeman, R. Shapira, "Determining the
// minimum-area encasing rectangle for an arbitrary closed curve", 1975); in space it need not be.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "fit/obb_hull.hpp"
#include "fit/obb_trials.hpp"
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

/// Tries the box on each face of a hull in space; of a flat one, on it as on a face.
template <class Scalar, class Observer>
class ObbFaceAligned {
 public:
  ObbFaceAligned(const ConvexHull<Scalar, 3>& hull, Observer& observe)
      : hull_(hull), observe_(observe), trials_(hull.vertices, observe) {}

  /// The best box's axes.
  Matrix<Scalar, 3> run() {
    if (hull_.affine_dim < 2) {
      const Matrix<double, 3> axes = hull_.affine_dim == 0 ? Matrix<double, 3>(Matrix<double, 3>::Identity())
                                                           : frame(at(1) - at(0), Vector<double, 3>::Zero());
      trials_.attempt(axes, hull_.indices, 2);
    } else if (hull_.affine_dim == 2) {
      attempt(widest_triangle());
    }
    for (std::size_t f = 0; f < hull_.facets.size(); ++f)
      if (f == 0 || !in_one_plane(hull_.facets[f - 1], hull_.facets[f])) attempt(hull_.facets[f]);
    return trials_.scalar_axes();
  }

 private:
  using Triangle = std::array<Index, 3>;

  [[nodiscard]] Vector<double, 3> at(Index i) const { return trials_.local().at[static_cast<std::size_t>(i)]; }

  /// A face that quickhull cut into triangles has them one after the other.
  [[nodiscard]] bool in_one_plane(const Triangle& f, const Triangle& g) const {
    const auto p = [&](Index i) -> Vector<double, 3> {
      return hull_.vertices[static_cast<std::size_t>(i)].template cast<double>();
    };
    return std::all_of(g.begin(), g.end(), [&](Index i) {
      return std::find(f.begin(), f.end(), i) != f.end() || orient3d(p(f[0]), p(f[1]), p(f[2]), p(i)) == 0;
    });
  }

  /// Of a flat polygon's fan the triangle whose plane is known best.
  [[nodiscard]] Triangle widest_triangle() const {
    Triangle widest{0, 1, 2};
    for (Index i = 1; i + 1 < static_cast<Index>(hull_.vertices.size()); ++i) {
      const Triangle next{0, i, i + 1};
      if (normal(widest).norm() < normal(next).norm()) widest = next;
    }
    return widest;
  }

  [[nodiscard]] Vector<double, 3> normal(const Triangle& f) const { return (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0])); }

  void attempt(const Triangle& face) {
    const RectangleFrame<3> rectangle = rectangle_along(normal(face), trials_.local().at);
    observe_.count(Operation::kDotProducts, 2 * static_cast<std::int64_t>(hull_.vertices.size()));
    trials_.attempt_and_tell(rectangle.axes, [&](const Obb<Scalar, 3>& box, bool better) {
      BoxTried<Scalar, 3> tried{{}, box, measure(box), better};
      for (const Index i : face) tried.on.push_back(hull_.indices[static_cast<std::size_t>(i)]);
      observe_(ObbStep<Scalar, 3>{better ? 3 : 2, true, trials_.box(), std::move(tried)});
    });
  }

  const ConvexHull<Scalar, 3>& hull_;
  Observer& observe_;
  ObbTrials<Scalar, 3, Observer> trials_;
};

/// The smallest box with a side on a face of the hull; in 2-D on an edge, which is the smallest of all. On a regular
/// tetrahedron it is twice as large as the smallest.
/// points: n >= 1 finite points, scene units. Expected O(n log n) time in 2-D; in 3-D as much for each face of the hull.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_face_aligned(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  Matrix<Scalar, Dim> axes;
  if constexpr (Dim == 2)  // the calipers tell of their steps on lines 2 and 3, as their own pseudocode has them
    axes = smallest_rectangle(hull, observe).axes.template cast<Scalar>();
  else
    axes = ObbFaceAligned<Scalar, std::remove_reference_t<Observer>>(hull, observe).run();
  return finish_on_hull<Scalar, Dim>(axes, hull, 4, observe);
}

}  // namespace snug::fit
