// What stands on the stage beside the lesson: in a lecture the way from lesson to lesson, and a newcomer's invitations.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// How far the lecture's buttons reach from the stage's left edge, in its top corner.
[[nodiscard]] float presentation_reach(const app::Look& look);
/// Leave, the previous and the next lesson, the lesson's text.
void draw_presentation(Shell& shell, const app::Rect& stage);
/// The lesson's title, on top of the numbers: a lecture has no bar.
[[nodiscard]] float title_height(const Shell& shell, const app::Look& look, float width);
void draw_title(Shell& shell, const app::Rect& rect);
/// What one who is new is asked to do next, beside what it speaks of.
void draw_invitation(const app::App& app, const app::Rect& stage);

}  // namespace snug::desktop
