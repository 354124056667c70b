// Shows the calls of Welzl's recursion as lectures print it: on the stage as a tree that grows and returns, with a
// meter of the stack, and beside it the stack itself.
#pragma once

#include <vector>

#include "app/brush.hpp"
#include "lesson/subjects/cloud/call_tree.hpp"

namespace snug::app {

/// Where each call stands across a tree's picture, from 0 to 1: one that makes no calls in a column of its own, any
/// other in the middle of those that it made.
[[nodiscard]] std::vector<float> columns_of(const lesson::CallTree& tree);

/// Whether the session shows that recursion.
[[nodiscard]] bool shows_calls(const lesson::Session& session);

/// See SubjectView::draw_inset: empty if the run is not that recursion's, or the stage has no room.
Rect draw_call_tree(Brush& brush, ImVec2 at);

/// Draws the stack and returns its height: 0 if the run is not that recursion's.
float draw_call_stack(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
