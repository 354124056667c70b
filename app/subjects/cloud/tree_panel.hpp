// Shows the calls of Welzl's recursion as lectures print it: as a tree that grows and returns, and as a stack.
#pragma once

#include <vector>

#include "app/look.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/cloud/call_tree.hpp"

namespace snug::app {

/// Where each call stands across a tree's picture, from 0 to 1: one that makes no calls in a column of its own, any
/// other in the middle of those that it made.
[[nodiscard]] std::vector<float> columns_of(const lesson::CallTree& tree);

/// Draws the panel and returns its height: 0 if the trace is not that of the recursion.
float draw_tree_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
