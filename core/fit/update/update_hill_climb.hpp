// Updates an axis-aligned box of a rotated body by hill climbing: its extreme vertices move along the edges of the hull
// to the new ones.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.2.5.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include "fit/update/watched_climb.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 5> kUpdateHillClimbPseudocode{
    "for each axis of the world, both ways",
    "  v ← last frame's extreme vertex",
    "  while a neighbour is farther: go there",
    "  bound ← v",
    "return box",
};

/// The tightest box, by six walks (in 2-D four) along the edges of the body's hull, each from where the last frame's
/// walk ended: a few vertices each, if the body rotated a little. The first frame walks farther. climb: for 2 Dim
/// directions. The box is the one that update_rebuild computes from the same vertices, bit for bit. If the body has
/// other points inside, each bound moves out by as much as rounding may have moved those points.
template <class Scalar, int Dim, StepObserver<UpdateStep<Aabb<Scalar, Dim>>> Observer = Ignore>
Updated<Aabb<Scalar, Dim>> update_hill_climb(HillClimb<Scalar, Dim>& climb, const Pose<Scalar, Dim>& pose,
                                             Observer&& observe = {}) {
  using Step = UpdateStep<Aabb<Scalar, Dim>>;
  Aabb<Scalar, Dim> box;
  std::vector<Index> support;
  for (int side = 0; side < 2 * Dim; ++side) {
    const int axis = side / 2;
    const bool greatest = side % 2 == 1;
    const Vector<Scalar, Dim> row = pose.rotation.row(axis).transpose();
    const Scalar size = row.cwiseAbs().dot(climb.largest());
    const Scalar error_bound = tolerance::kClimb<Scalar> * size + 8 * std::numeric_limits<Scalar>::denorm_min();
    const auto value = [&](Index v) {
      const Scalar along = turned_coordinate<Scalar, Dim>(pose.rotation, axis, climb.vertex(v));
      return greatest ? along : -along;
    };
    ExtremeClimbed fact{axis, greatest, {}, 0};
    const Climbed<Scalar> found = climb_watched(climb, side, value, error_bound, box, fact, observe);
    const Scalar bound = climb.all_points() ? found.value : found.value + error_bound;
    (greatest ? box.max : box.min)[axis] = (greatest ? bound : -bound) + pose.translation[axis];
    observe.count(Operation::kPointsTouched, found.looked_at);
    observe.count(Operation::kDotProducts, found.looked_at);
    observe.count(Operation::kComparisons, found.looked_at - 1);
    if constexpr (kWatched<Observer>) {
      support.push_back(climb.end(side));
      observe(Step{3, side + 1 == 2 * Dim, box, std::move(fact)});
    }
  }
  observe(Step{4, true, box, Finished{std::move(support)}});
  return {box};
}

}  // namespace snug::fit
