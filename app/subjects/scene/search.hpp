// Draws what a search for pairs does for one body of the frame: what its AABB is compared with, and what the search
// keeps: the sorted intervals, the tree's nodes, the cells of the grid.
#pragma once

#include <optional>
#include <vector>

#include "app/brush.hpp"
#include "lesson/subjects/scene/searched.hpp"

namespace snug::app {

/// The search of a frame, seen from one body.
struct SearchShown {
  hierarchy::PairSearch search;
  Index body = kNoIndex;      // the one pointed at or selected, or else one that is compared with the most others
  std::vector<Index> others;  // those that it was compared with
  std::vector<Index> active;  // of a sweep: the active list when it comes to the body
};

/// None before the first frame, in a crowd, while a question is open, and where search_shown gives none.
[[nodiscard]] std::optional<SearchShown> search_at(const Brush& brush, const lesson::SceneFrame& frame);

void draw_search(Brush& brush, const lesson::SceneFrame& frame, const SearchShown& shown);

/// How much of the stage's height the picture of a sweep takes; 0 if it would leave too little for the bodies, for
/// another search, or for more bodies than it can show.
[[nodiscard]] float sweep_room(const Look& look, const lesson::Session& session, const Rect& stage);
/// Draws the sorted intervals of a sweep in the stage's corner, below a height. Returns the room that they take; empty
/// for another search, or where the stage is too small.
Rect draw_sweep_inset(Brush& brush, const lesson::SceneFrame& frame, const SearchShown& shown, ImVec2 at);

}  // namespace snug::app
