// A scene's frame; for this folder.
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// The bodies where the frame has them, their loose volumes, and which pairs each stage of the funnel left.
void draw_scene(Brush& brush);

}  // namespace snug::app
