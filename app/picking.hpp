// Finds the point that a pointer means.
#pragma once

#include <span>

#include "app/camera.hpp"
#include "geometry/vector.hpp"

namespace snug::app {

/// How far a pointer may be from a point that it means, page pixels: a mouse, and a finger's 44 px target.
inline constexpr float kMouseReach = 11;
inline constexpr float kFingerReach = 22;

/// Among more points than this in space, a drag is meant to rotate the view. So a press grabs only a point that it hits
/// right in its middle, or the selected one.
inline constexpr Index kSparse = 60;
inline constexpr float kExactReach = 1.5f, kSelectedReach = 6;

/// The point that a drag from (x, y) moves; kNoIndex if it moves the view. A finger cannot hit the middle of a point,
/// so among many points it drags only the selected one.
[[nodiscard]] Index grab(std::span<const ScreenPoint> points, bool space, Index selected, float x, float y,
                         bool finger);

/// The visible point nearest to (x, y) within reach; of several within a pixel, the one in front; kNoIndex for
/// none.
[[nodiscard]] Index pick(std::span<const ScreenPoint> points, float x, float y, float reach);

}  // namespace snug::app
