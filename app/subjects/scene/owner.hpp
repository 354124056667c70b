// Which bodies a scene's points are of.
#pragma once

#include <cstddef>

#include "lesson/subjects/scene/scene_set.hpp"

namespace snug::app {

/// Where the lesson's points are in the declaration: the first body of all of them, or the first of one at each.
struct Owner {
  std::size_t body = 0;
  bool of_points = false, at_points = false;
};

[[nodiscard]] Owner owner_of(const lesson::SceneSet& scene);

}  // namespace snug::app
