// What a step of an update shows besides its volume.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/polytope.hpp"
#include "app/shown.hpp"
#include "lesson/subjects/update/update.hpp"

namespace snug::app {

struct UpdateShown : Shown {
  const lesson::UpdateSubject* body = nullptr;
  const lesson::UpdateRun* run = nullptr;
  std::optional<Polytope> hull;  // of the body, in the world; none of too many points

  /// The climb at hand.
  struct Climb {
    int axis = 0;
    bool greatest = false;
    Index vertex = kNoIndex;                  // where it is
    std::vector<Index> neighbors;             // which were compared with the vertex in this step
    Index best = kNoIndex;                    // where it goes next
    std::vector<std::array<Index, 2>> edges;  // that it has walked along
    bool over = false;                        // whether it has ended
  };
  std::optional<Climb> climb;

  /// A bound that is known, while the volume is not finished: axis · x = at.
  struct Bound {
    Point3 axis = Point3::Zero();
    double at = 0;
    bool fresh = false;  // whether this step found it
  };
  std::vector<Bound> bounds;
  std::optional<Index> farthest;  // from the pivot, once that is known
};

[[nodiscard]] UpdateShown update_shown_at(const lesson::Session& session);

}  // namespace snug::app
