// What is in the picture of a scene's frame.
#pragma once

#include "scene/scene.hpp"

namespace snug::lesson {

/// Counted by body, but for the effects.
struct Pictured {
  int effects = 0;  // that are constructed
  int shadows = 0, trails = 0, rays = 0;
  int culled = 0;  // bodies outside the view
};
[[nodiscard]] Pictured pictured_in(const scene::Scene& scene);

}  // namespace snug::lesson
