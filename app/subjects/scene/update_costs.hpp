// What the updates of a volume cost and how loose they are: frame by frame, and all of the lesson's beside each other.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws the charts of a scene whose volume is updated, in the current pane, and returns their height. A figure that is
/// still to be predicted is not drawn.
float draw_update_costs(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
