#include "app/subjects/tree/shown.hpp"

#include <algorithm>

namespace snug::app {
namespace {

using lesson::Branch;
using lesson::Met;

TreeInk ink_of_met(const Palette& p, Met met) {
  switch (met) {
    case Met::kOpen: return {p.examined, p.examined_text};
    case Met::kMet: return {p.current, p.current_text, p.fill};
    case Met::kMissed: return {.line = p.wrong, .words = p.wrong_text, .crossed = true};
    case Met::kUnder: return {.line = with_alpha(p.muted, 0.4f), .words = p.muted, .pale = true};
    case Met::kTaken: return {p.optimum, p.optimum_text, p.fill};
    case Met::kNot: break;
  }
  return {p.muted, p.ink};
}

/// The copy's branch that a step is about.
Index partner_of(const lesson::TreeRun& run, int step) {
  const auto* tested = std::get_if<hierarchy::PairTested>(&run.trace()[step].step.fact);
  if (tested == nullptr) return kNoIndex;
  return tested->bodies ? run.leaf_of(tested->b) : tested->b;
}

/// A node or a leaf of two trees: tested by this step, part of a pair that waits, or of a pair that was found.
TreeInk ink_of_pair(const Palette& p, const lesson::PairState& state, Index branch, TreeSide side, bool found) {
  const auto at = static_cast<std::size_t>(side);
  if (state.now && (*state.now)[at] == branch) return ink_of_met(p, state.apart ? Met::kMissed : Met::kMet);
  const bool waits = std::any_of(state.waiting.begin(), state.waiting.end(),
                                 [&](const lesson::NodePair& pair) { return pair[at] == branch; });
  return ink_of_met(p, waits ? Met::kOpen : found ? Met::kMet : Met::kNot);
}

bool is_found(const lesson::PairState& state, Index box, TreeSide side) {
  return std::any_of(state.found.begin(), state.found.end(),
                     [&](const lesson::NodePair& pair) { return pair[static_cast<std::size_t>(side)] == box; });
}

/// What an open question is about, which its step will show.
void show_asked(TreeShown& shown, const lesson::Session& session) {
  const lesson::Asked* asked = session.conversation().asked();
  if (asked == nullptr) return;
  shown.spoken_of.clear();
  shown.split = nullptr;
  if (asked->step != asked->fact) return;  // asked long before
  const auto& fact = shown.run->trace()[asked->fact].step.fact;
  shown.asks_next = asked->kind->name == "next_node";
  if (shown.asks_next) return;
  shown.branch = shown.run->branch_of(asked->fact), shown.partner = partner_of(*shown.run, asked->fact);
  if (const auto* inserted = std::get_if<hierarchy::BodyInserted>(&fact)) shown.incoming = inserted->body;
  const bool makes = shown.incoming != kNoIndex || std::holds_alternative<hierarchy::NodesMerged>(fact);
  if (makes || std::holds_alternative<hierarchy::Done>(fact)) shown.branch = kNoIndex;  // it is not there yet
}

}  // namespace

TreeShown tree_shown_at(const lesson::Session& session) {
  TreeShown shown{shown_at(session)};
  shown.run = &lesson::tree_run(session.player().run(0));
  shown.step = session.player().step();
  shown.spoken_of = named_now(session);
  if (shown.step > 0) {
    const auto& fact = shown.run->trace()[shown.step - 1].step.fact;
    shown.branch = shown.run->branch_of(shown.step - 1), shown.partner = partner_of(*shown.run, shown.step - 1);
    shown.priced = std::get_if<hierarchy::SplitsPriced>(&fact);
    shown.split = std::get_if<hierarchy::SplitChosen>(&fact);
    if (shown.split != nullptr && shown.step > 1)
      shown.priced = std::get_if<hierarchy::SplitsPriced>(&shown.run->trace()[shown.step - 2].step.fact);
    if (std::holds_alternative<hierarchy::Done>(fact)) shown.branch = kNoIndex;
  }
  show_asked(shown, session);
  return shown;
}

const lesson::Forest& forest_on(const TreeShown& shown, TreeSide side) {
  return side == TreeSide::kOwn ? shown.forest() : shown.run->pairing()->copy;
}

TreeInk ink_of(const Palette& palette, const TreeShown& shown, Index branch, TreeSide side) {
  if (const lesson::PairState* state = shown.pairs()) {
    const Branch& own = forest_on(shown, side).at(branch);
    return ink_of_pair(palette, *state, branch, side, !own.divides() && is_found(*state, own.boxes.front(), side));
  }
  TreeInk ink{palette.previous, palette.ink};
  if (shown.run->is_merging() && !shown.run->has_volume(branch, shown.step))
    return {.line = with_alpha(palette.muted, 0.55f), .words = palette.muted, .pale = true};
  if (const auto* state = shown.query()) ink = ink_of_met(palette, state->nodes[branch]);
  else if (branch == shown.branch || shown.finished) ink = {palette.current, palette.current_text, palette.fill};
  return ink;
}

TreeInk ink_of_box(const Palette& palette, const TreeShown& shown, Index box, TreeSide side) {
  if (const lesson::PairState* state = shown.pairs()) {
    const Index leaf = shown.run->leaf_of(box);
    if (state->now && (*state->now)[static_cast<std::size_t>(side)] == leaf)
      return ink_of_pair(palette, *state, leaf, side, false);
    return ink_of_met(palette, is_found(*state, box, side) ? Met::kMet : Met::kNot);
  }
  if (const auto* state = shown.query()) return ink_of_met(palette, state->boxes[box]);
  if (box == shown.incoming) return {palette.examined, palette.examined_text};
  return {palette.point, palette.ink};
}

}  // namespace snug::app
