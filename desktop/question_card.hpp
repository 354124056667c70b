// The conversation on the stage's foot, in the sentence's place: a question, what came of its answer, and in the end
// how all of them came out.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// After the stage was drawn, over it. Leaves in shell.foot how much of it is covered.
void draw_question_card(Shell& shell, const app::Rect& stage);

}  // namespace snug::desktop
