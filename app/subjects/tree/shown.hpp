// What a step of building a tree, or of a query through one, shows.
#pragma once

#include "app/palette.hpp"
#include "app/shown.hpp"
#include "lesson/subjects/tree/tree.hpp"

namespace snug::app {

struct TreeShown : Shown {
  const lesson::TreeRun* run = nullptr;
  int step = 0;
  /// The branch that the step is about, or that an open question asks about, and of two trees that of the copy;
  /// kNoIndex for none.
  Index branch = kNoIndex, partner = kNoIndex;
  bool asks_next = false;  // whether it is asked which node is next: the stack does not tell
  /// The box that a question about an insertion speaks of.
  Index incoming = kNoIndex;
  const hierarchy::SplitsPriced* priced = nullptr;  // until its node is divided
  const hierarchy::SplitChosen* split = nullptr;

  [[nodiscard]] const lesson::Forest& forest() const { return run->forest(step); }
  [[nodiscard]] const lesson::QueryState* query() const { return run->is_query() ? &run->state(step) : nullptr; }
  [[nodiscard]] const lesson::PairState* pairs() const {
    return run->pairing() != nullptr ? &run->pairing()->states[step] : nullptr;
  }
};

[[nodiscard]] TreeShown tree_shown_at(const lesson::Session& session);

/// A branch's or a box's colours: those of its state, the same on the stage and in the tree's picture.
struct TreeInk {
  Color line = 0, words = 0;
  float fill = 0;        // alpha
  bool crossed = false;  // left out by a test
  bool pale = false;     // left out untested
};
/// Which of two trees: the lesson's own, and where two are tested against each other its copy.
enum class TreeSide : std::uint8_t { kOwn, kCopy };
[[nodiscard]] TreeInk ink_of(const Palette& palette, const TreeShown& shown, Index branch,
                             TreeSide side = TreeSide::kOwn);
[[nodiscard]] TreeInk ink_of_box(const Palette& palette, const TreeShown& shown, Index box,
                                 TreeSide side = TreeSide::kOwn);
[[nodiscard]] const lesson::Forest& forest_on(const TreeShown& shown, TreeSide side);
[[nodiscard]] inline Index branch_on(const TreeShown& shown, TreeSide side) {
  return side == TreeSide::kOwn ? shown.branch : shown.partner;
}

}  // namespace snug::app
