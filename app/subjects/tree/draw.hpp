// Draws boxes, the nodes around them, and the query; below them the tree; and beside the stage its numbers.
#pragma once

#include "app/brush.hpp"
#include "app/panel_words.hpp"
#include "app/subjects/tree/shown.hpp"

namespace snug::app {

/// Where the tree is drawn: below the rest, or on a stage that is much wider than high at its right.
enum class TreePlace : std::uint8_t { kBelow, kBeside };

void draw_tree(Brush& brush, const TreeShown& shown, TreePlace place);
/// Draws the tree in its room, and a copy's beside it.
void draw_tree_picture(Brush& brush, const TreeShown& shown, TreePlace place);
[[nodiscard]] lesson::Box2 tree_room(const lesson::Session& session, TreePlace place);
/// Around all that can be dragged, and the frustum of a query.
[[nodiscard]] lesson::Box2 stage_room(const lesson::Session& session);

/// Draws a query's stack or, where borders are priced, the curve of their costs. Returns the height.
float draw_tree_panel(const Look& look, const TreeShown& shown, ImVec2 at, float width);
/// Buttons for the nodes without a parent, of which two are chosen and merged, and one that takes a merger back. first:
/// the one that was chosen, kNoIndex for none. Returns the height.
float draw_hand_panel(const Look& look, lesson::Session& session, const TreeShown& shown, ImVec2 at, float width,
                      Index& first);
/// Where a ray's order is chosen by hand: two buttons, for the child that comes next, and one that takes the last
/// choice back. Returns the height.
float draw_order_panel(const Look& look, lesson::Session& session, const TreeShown& shown, ImVec2 at, float width);
/// What each way costs with many boxes like those on the stage, timed one after the other while nothing moves, once its
/// run was at the end: a question may come before.
class TreeTimes {
 public:
  struct Entry {
    const lesson::Method* method = nullptr;
    lesson::TreeTime timed;
    std::uint64_t stage = 0;  // the number of the stage that it was timed on
  };
  /// Times the next way, once nothing has moved for a while: a way may take longer than a frame. session: at the end of
  /// a run.
  void measure(const lesson::Session& session);
  [[nodiscard]] bool working() const { return working_; }
  void pause() { working_ = false; }
  /// Null if it has never been timed.
  [[nodiscard]] const Entry* of(const lesson::Method& method) const;
  [[nodiscard]] bool is_of_now(const Entry& entry) const { return entry.stage == stage_; }

 private:
  std::vector<Entry> entries_;
  std::vector<const lesson::Method*> ended_;  // those whose run was at the end
  std::uint64_t stage_ = 0;
  lesson::Rows rows_;  // of that stage, and its situation
  std::string situation_;
  int still_ = 0;  // frames since the last change
  bool working_ = false;
};
/// Whether the times are to be seen: at the end of building a tree, or of moving one.
[[nodiscard]] bool shows_times(const lesson::Session& session);
/// A row for each way: the SAH cost of its tree, and its time. Returns the height.
float draw_times_panel(const Look& look, const lesson::Session& session, const TreeTimes& times, ImVec2 at,
                       float width);
/// The same in words.
[[nodiscard]] PanelWords times_in_words(const lesson::Session& session, const TreeTimes& times);
/// The curve alone: for each axis the cost at each border, its minimum marked.
float draw_cost_curve(const Look& look, const hierarchy::SplitsPriced& priced, ImVec2 at, float width);

}  // namespace snug::app
