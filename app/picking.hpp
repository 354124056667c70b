// Which point a pointer means.
#pragma once

#include <span>

#include "app/camera.hpp"
#include "geometry/vector.hpp"

namespace snug::app {

/// How far a pointer may be from a point that it means, page pixels: a mouse, and a finger's 44 px target.
inline constexpr float kMouseReach = 11;
inline constexpr float kFingerReach = 22;

/// The point nearest to (x, y) within reach; of those that are as near to within a pixel, the one in front.
/// kNoIndex for none. points: those that are not visible cannot be picked.
[[nodiscard]] Index pick(std::span<const ScreenPoint> points, float x, float y, float reach);

}  // namespace snug::app
