// What the updates of a body's volume cost, and how loose each is over a whole turn.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws the charts in the current pane, and returns their height. What is still to be predicted is not drawn.
float draw_turn_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
