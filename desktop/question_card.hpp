// The questions, at the bottom of the stage instead of the step's sentence: each question, its outcome, and at the end
// a summary of all of them.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// Draws the card over the stage, which is drawn before it. Sets shell.foot to how much of the stage it covers.
void draw_question_card(Shell& shell, const app::Rect& stage);

}  // namespace snug::desktop
