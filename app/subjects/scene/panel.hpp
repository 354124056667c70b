// What a scene's frame came to: how many pairs each stage left, how loose the volume was over time, and what each
// effect did.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// The effects' rows switch them off and on. Draws at a place of the current pane, as wide as width, and returns the
/// height.
float draw_scene_panel(const Look& look, lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
