// The questions, at the bottom of the stage instead of the step's sentence, in a lecture beside it: each question, its
// outcome, and at the end a summary of all of them.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// How much of the stage's foot the card covers, as it was measured.
[[nodiscard]] float covered_by_question(const Shell& shell);
/// Draws the card. place: the stage, which is drawn before it; in a lecture the card's own. Sets shell.question_height.
void draw_question_card(Shell& shell, const app::Rect& place);

}  // namespace snug::desktop
