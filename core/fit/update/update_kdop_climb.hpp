// Updates a k-DOP of a rotated body by hill climbing on the hull: one climb for each of its bounds.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.6.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include "fit/update/watched_climb.hpp"
#include "geometry/kdop_project.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 5> kUpdateKdopClimbPseudocode{
    "for each of the k / 2 axes, both ways",
    "  v ← last frame's extreme vertex",
    "  while a neighbour is farther: go there",
    "  bound ← v, rounded outwards",
    "return k-DOP",
};

/// The tightest k-DOP, by hill climbing along each of its axes. This is where k-DOPs are weak: their axes stay fixed
/// while the body rotates, so no bound of the last frame can be reused. A rotation costs k walks; a box needs six, a
/// sphere or an oriented box none. k: one that exists in Dim dimensions. climb: for k directions. The result is the one
/// that kdop_fit computes from the same placed vertices, bit for bit. If the body has other points inside, each bound
/// moves out by as much as rounding may have moved those points.
template <class Scalar, int Dim, StepObserver<UpdateStep<Kdop<Scalar, Dim>>> Observer = Ignore>
Updated<Kdop<Scalar, Dim>> update_kdop_climb(HillClimb<Scalar, Dim>& climb, int k, const Pose<Scalar, Dim>& pose,
                                             Observer&& observe = {}) {
  using Step = UpdateStep<Kdop<Scalar, Dim>>;
  Kdop<Scalar, Dim> kdop{.k = k};
  const auto axes = kdop_axes<Dim>(k);
  std::vector<Index> support;
  const Vector<Scalar, Dim> reach =
      turned<Scalar, Dim>(pose.rotation.cwiseAbs(), climb.largest()) + pose.translation.cwiseAbs();
  for (int side = 0; side < k; ++side) {
    const std::size_t slab = side / 2;
    const bool greatest = side % 2 == 1;
    KdopAxis<Dim> outward = axes[slab];
    KdopAxis<Dim> sizes{};
    for (std::size_t i = 0; i < outward.size(); ++i) {
      outward[i] *= greatest ? 1 : -1;
      sizes[i] = std::abs(outward[i]);
    }
    const Scalar size = project<Scalar, Dim>(sizes, reach);
    const Scalar error_bound = tolerance::kClimbKdop<Scalar> * size + 16 * std::numeric_limits<Scalar>::denorm_min();
    const auto value = [&](Index v) { return project_up<Scalar, Dim>(outward, placed(pose, climb.vertex(v))); };
    ExtremeClimbed fact{static_cast<int>(slab), greatest, {}, 0};
    const Climbed<Scalar> found = climb_watched(climb, side, value, error_bound, kdop, fact, observe);
    const Scalar bound = climb.all_points() ? found.value : found.value + error_bound;
    (greatest ? kdop.max : kdop.min)[slab] = greatest ? bound : 0 - bound;
    observe.count(Operation::kPointsTouched, found.looked_at);
    observe.count(Operation::kDotProducts, found.looked_at * (Dim + 1));  // placed, then projected
    observe.count(Operation::kComparisons, found.looked_at - 1);
    if constexpr (kWatched<Observer>) {
      support.push_back(climb.end(side));
      const bool has_volume = side + 1 >= 2 * Dim;
      if (has_volume && greatest) imply_slabs(kdop, slab + 1);
      observe(Step{3, has_volume, kdop, std::move(fact)});
    }
  }
  observe(Step{4, true, kdop, Finished{std::move(support)}});
  return {kdop};
}

}  // namespace snug::fit
