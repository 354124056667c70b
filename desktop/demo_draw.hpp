// What a demo shows besides its lesson: the class's vote, and in a second window what the lecturer reads.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// The vote on the question that stands open or was answered: without a number until the answer is revealed; then with
/// its shares, and for each place a dot of that size.
void draw_vote(Shell& shell, const app::Rect& stage);
/// The notes: what is said now, what the next press does, the vote's numbers, the time of day and since when it runs.
void draw_notes(ImDrawList* list, const app::Look& look, const app::Rect& rect, const DemoPlay& demo, const Hall& hall);

}  // namespace snug::desktop
