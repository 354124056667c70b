// Welzl's list and the calls of his recursion, where they stand at the step: nothing of them has a place on the stage.
#pragma once

#include <vector>

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// The places of a list that are shown when it is too long to be shown whole: its front and those around the current
/// one, in order; kListGap marks a gap. at: the current place. most: how many cells there is room for, 8 or more.
inline constexpr int kListGap = -1;
[[nodiscard]] std::vector<int> shown_places(int size, int at, int most);

/// Draws at a place and returns how high it is: 0 where the trace has no list at this step.
float draw_call_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
