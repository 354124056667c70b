// The oriented box of least volume.
// Source: J. O'Rourke, "Finding minimal enclosing boxes", 1985, for the theorem: two adjacent faces of the smallest box
// lie on edges of the hull. The algorithm is not his, but a branch and bound over the pairs of edges. In 2-D: H.
// Freeman, R. Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve", 1975.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_edge_pairs.hpp"
#include "fit/obb/obb_face_aligned.hpp"
#include "fit/obb/obb_hull.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "fit/obb/obb_trials.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 10> kObbExactPseudocode{
    "hull ← convex hull of the points",
    "best ← on its principal axes; in 2-D on each edge",
    "shrink best by rectangles across its axes",
    "  if the box on one is smaller: keep it",
    "for each pair of edges e, f of the hull",
    "  rotate the box with one face on e, the next on f",
    "  rule out angles whose boxes a bound shows to be larger",
    "  halve the others; keep what is smaller",
    "extents ← least and greatest along each",
    "return box",
};

/// The smallest box of a hull in space.
template <class Scalar, class Observer>
class ObbExact {
 public:
  ObbExact(const ConvexHull<Scalar, 3>& hull, Observer& observe)
      : hull_(hull), observe_(observe), trials_(hull.vertices, observe) {}

  /// Its axes.
  Matrix<Scalar, 3> run() {
    start();
    if (hull_.affine_dim == 2) lay_in_plane();
    if (hull_.affine_dim == 3) search();
    return trials_.scalar_axes();
  }

 private:
  using Step = ObbStep<Scalar, 3>;

  void start() {
    const PointSet<Scalar, 3> vertices = vertices_of(hull_);
    PartCounterFor<Observer> tally;
    const auto axes = watched_principal_axes(vertices.span(), 1, tally);
    hand_on(tally, observe_);
    trials_.attempt(axes.template cast<double>(), std::array<Index, 0>{}, 1);
    shrink_by_rectangles(trials_, hull_.indices, 2, 0, observe_);
  }

  /// The principal axes of a sliver may be off by so much that the boxes on them are thicker than rounding.
  void lay_in_plane() {
    const std::vector<Vector<double, 3>>& vertices = trials_.local().at;
    RectangleFrame<3> found = watched_rectangle_along(watched_flat_normal(vertices, observe_), vertices, observe_);
    attempt_rectangle(trials_, on_points(found, hull_.indices), 2, observe_);
  }

  void search() {
    PartCounterFor<Observer> built;
    const HullSolid solid(hull_, built);
    EdgePairSearch pairs(solid, trials_.axes());
    count_box<3>(hull_.vertices.size(), built);  // of the box to beat
    hand_on(built, observe_);
    for (Index e = 0; e < static_cast<Index>(solid.edges().size()); ++e) {
      PartCounterFor<Observer> spent;
      const PairTally tally = pairs.search(e, spent);
      hand_on(spent, observe_);
      if (tally.smaller_on) trials_.attempt(pairs.axes(), indices(*tally.smaller_on), 7);
      const auto ends = indices(solid.edges()[e]);
      observe_(
          Step{6, true, trials_.box(), EdgeSearched{ends[0], ends[1], tally.pairs, tally.ruled_out, tally.halvings}});
    }
  }

  template <std::size_t kN>
  [[nodiscard]] std::array<Index, kN> indices(std::array<Index, kN> places) const {
    for (Index& i : places) i = hull_.indices[i];
    return places;
  }

  const ConvexHull<Scalar, 3>& hull_;
  Observer& observe_;
  ObbTrials<Scalar, 3, Observer> trials_;
};

/// The smallest box, proven so but for rounding (tolerance::kBoxProof).
/// points: n >= 1 finite points, scene units. Expected O(n log n) time for the hull, then O(h log h) for its h vertices
/// in 2-D. In 3-D each edge is paired with those that have a normal perpendicular to one of its own, about O(sqrt h) on
/// a round hull; finding them takes a pass over all edges, so O(h^2) in all, with a small constant. In 3-D it takes at
/// most kMostRectangles steps for rectangles, two for each edge of the hull (a smaller box, and what was searched), of
/// which there are at most 3 h - 6, and four more.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_exact(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Watcher = std::remove_reference_t<Observer>;
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  Matrix<Scalar, Dim> axes;
  if constexpr (Dim == 2) {
    axes = smallest_rectangle(hull, observe).axes.template cast<Scalar>();
  } else {
    axes = ObbExact<Scalar, Watcher>(hull, observe).run();
  }
  return finish_on_hull<Scalar, Dim>(axes, hull, 8, observe);
}

}  // namespace snug::fit
