// The numbers beside the stage: of the step, of the algorithms beside each other, and of the proof.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws into the current pane, which scrolls where it does not fit.
void draw_inspector(const Look& look, const lesson::Session& session, const Rect& rect);

}  // namespace snug::app
