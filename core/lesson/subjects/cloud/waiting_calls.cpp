#include "lesson/subjects/cloud/waiting_calls.hpp"

#include <algorithm>

namespace snug::lesson {
namespace {

using namespace fit;

/// The list at the start of the recursion. The outermost call visits its points in this order, because points only move
/// to the front among those already visited. Empty if the trace is not Welzl's.
std::vector<Index> shuffled_list(FitTrace trace) {
  std::vector<Index> list;
  bool forces = false;
  for (const auto& entry : trace) {
    forces = forces || std::holds_alternative<BoundaryForced>(entry.step.fact);
    const auto* examined = std::get_if<PointExamined>(&entry.step.fact);
    if (examined != nullptr && examined->depth == 0) list.push_back(examined->point);
  }
  return forces ? list : std::vector<Index>{};
}

/// Follows the facts from the beginning.
struct CallFollower {
  WelzlState state;

  void operator()(const PointExamined& fact) {
    state.moved = kNoIndex;
    WaitingCall& call = running(fact.depth);
    if (state.list[call.done] != fact.point) ++call.done;  // the point before it led to no call
    call.at = fact.point;
    if (!fact.outside) ++call.done;
  }
  void operator()(const BoundaryForced& fact) {
    state.moved = kNoIndex;
    const WaitingCall& caller = running(fact.depth - 1);
    const int before = caller.done;
    state.calls.push_back({fact.boundary, before});
  }
  void operator()(const MovedToFront& fact) {
    WaitingCall& call = running(fact.depth);
    state.moved = fact.point;
    state.moved_from = call.done++;
    call.at = kNoIndex;
    std::rotate(state.list.begin(), state.list.begin() + state.moved_from, state.list.begin() + call.done);
  }
  void operator()(const AllChecked&) { state.moved = kNoIndex, state.calls.clear(); }
  void operator()(const SupportReplaced&) { state.moved = kNoIndex, state.calls.clear(); }
  void operator()(const Finished&) { state.moved = kNoIndex, state.calls.clear(); }
  void operator()(const auto&) {}

  /// The call at that depth; the calls below it have ended.
  WaitingCall& running(int depth) {
    state.calls.resize(static_cast<std::size_t>(depth) + 1);
    return state.calls.back();
  }
};

}  // namespace

WelzlState welzl_state(FitTrace trace, int steps) {
  CallFollower follower{{.list = shuffled_list(trace)}};
  WelzlState& state = follower.state;
  if (state.list.empty()) return {};
  state.calls = {{.length = static_cast<int>(state.list.size())}};
  for (const auto& entry : trace.first(steps)) std::visit(follower, entry.step.fact);
  return std::move(state);
}

}  // namespace snug::lesson
