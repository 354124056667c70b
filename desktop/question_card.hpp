// The questions, at the bottom of the stage instead of the step's sentence, in a lecture beside it: each question, its
// outcome, and at the end a summary of all of them.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// Draws the card. place: the stage, which is drawn before it; in a lecture the card's own. Sets shell.question_height,
/// and shell.foot to how much of the stage it covers.
void draw_question_card(Shell& shell, const app::Rect& place);

}  // namespace snug::desktop
