// The panel of a scene's frame: how many pairs each stage left, how loose the volume was over time, and what each
// effect did.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws the panel in the current pane and returns its height. The effects' rows switch them off and on; before the
/// first frame of a lesson about them, out of the declaration and in. with_graph: whether their graph is drawn here.
float draw_scene_panel(const Look& look, lesson::Session& session, ImVec2 at, float width, bool with_graph);

}  // namespace snug::app
