// Draws a scene's frame; for this folder only.
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// Draws the bodies in the frame, their loose volumes, and the pairs that each stage of the funnel left.
void draw_scene(Brush& brush);

}  // namespace snug::app
