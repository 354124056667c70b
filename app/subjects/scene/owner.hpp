// Which bodies a scene's points belong to.
#pragma once

#include <cstddef>

#include "lesson/subjects/scene/scene_set.hpp"

namespace snug::app {

/// Where the lesson's points are in the declaration: the body made of all of them, or the first of those at each.
struct Owner {
  std::size_t body = 0;
  bool of_points = false, at_points = false;
};

[[nodiscard]] Owner owner_of(const lesson::SceneSet& scene);

/// The declared body that the i-th body of the scene is one of. points: how many there are.
[[nodiscard]] const lesson::SceneBody& declared(const lesson::SceneSet& scene, std::size_t i, std::size_t points);

}  // namespace snug::app
