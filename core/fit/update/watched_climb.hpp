// What the updates by hill climbing share: a climb that an observer may watch, vertex by vertex.
#pragma once

#include <utility>
#include <vector>

#include "fit/hull/hill_climb.hpp"
#include "fit/update/update.hpp"

namespace snug::fit {

/// Climbs along a side of an axis, the greater end or the lesser one. value, error_bound: as of HillClimb::climb. An
/// observer sees each vertex of the walk before fact is filled with all of it; so_far: the volume in the meantime.
template <class VolumeType, class Scalar, int Dim, class Value, class Observer>
Climbed<Scalar> climb_watched(HillClimb<Scalar, Dim>& climb, int side, Value&& value, Scalar error_bound,
                              [[maybe_unused]] const VolumeType& so_far, [[maybe_unused]] ExtremeClimbed& fact,
                              [[maybe_unused]] Observer& observe) {
  if constexpr (!kWatched<Observer>) {
    return climb.climb(side, value, error_bound);
  } else {
    constexpr int kWalkLine = 2;
    std::vector<WalkStep> walk;
    const Climbed<Scalar> found = climb.climb(side, value, error_bound, &walk);
    fact.path = {walk.front().vertex};
    fact.looked_at = found.looked_at;
    for (WalkStep& at : walk) {
      if (at.best != fact.path.back()) fact.path.push_back(at.best);
      observe(UpdateStep<VolumeType>{
          kWalkLine, false, so_far,
          NeighborsCompared{fact.axis, fact.greatest, at.vertex, std::move(at.neighbors), at.best}});
    }
    return found;
  }
}

}  // namespace snug::fit
