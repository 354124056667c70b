// Draws boxes, the nodes around them, and the query; below them the tree; and beside the stage its numbers.
#pragma once

#include "app/brush.hpp"
#include "app/subjects/tree/shown.hpp"

namespace snug::app {

void draw_tree(Brush& brush, const TreeShown& shown);
/// Draws the tree in its room.
void draw_tree_below(Brush& brush, const TreeShown& shown);
/// Where the tree is drawn: below the rest.
[[nodiscard]] lesson::Box2 tree_room(const lesson::Session& session);
/// Around all that can be dragged, and the frustum of a query.
[[nodiscard]] lesson::Box2 stage_room(const lesson::Session& session);

/// Draws a query's stack or, where borders are priced, the curve of their costs. Returns the height.
float draw_tree_panel(const Look& look, const TreeShown& shown, ImVec2 at, float width);
/// Buttons for the nodes without a parent, of which two are chosen and merged, and one that takes a merger back. first:
/// the one that was chosen, kNoIndex for none. Returns the height.
float draw_hand_panel(const Look& look, lesson::Session& session, const TreeShown& shown, ImVec2 at, float width,
                      Index& first);
/// The curve alone: for each axis the cost at each border, its minimum marked.
float draw_cost_curve(const Look& look, const hierarchy::SplitsPriced& priced, ImVec2 at, float width);

}  // namespace snug::app
