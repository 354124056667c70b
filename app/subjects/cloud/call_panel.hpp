// Shows Welzl's list and the calls of his recursion at the step, which cannot be shown on the stage.
#pragma once

#include <vector>

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// The places of a long list that are shown: its front and those around the current one, in order; kListGap marks a
/// gap. at: the current place. most: how many cells there is room for, 8 or more.
inline constexpr int kListGap = -1;
[[nodiscard]] std::vector<int> shown_places(int size, int at, int most);

/// Draws the panel and returns its height: 0 if the trace has no list at this step.
float draw_call_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
