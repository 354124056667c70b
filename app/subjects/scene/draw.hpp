// Draws a scene's frame; for this folder only.
#pragma once

#include "app/brush.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {

/// Draws the bodies in the frame, their loose volumes, and the pairs that each stage of the funnel left.
void draw_scene(Brush& brush);
/// Draws the local frame of a body of points, and what the method that updates its volume keeps there: the local AABB,
/// the sphere about the pivot, or the hull.
void draw_update(Brush& brush, const lesson::SceneFrame& frame);

}  // namespace snug::app
