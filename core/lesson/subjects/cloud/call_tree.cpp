#include "lesson/subjects/cloud/call_tree.hpp"

#include <algorithm>

namespace snug::lesson {
namespace {

using namespace fit;

/// Follows the facts from the beginning.
struct TreeFollower {
  CallTree tree;
  std::int64_t bytes_per_call = 0;

  void operator()(const CallEntered& fact) {
    enter({.depth = fact.depth, .point = fact.point, .left = fact.left, .boundary = fact.boundary});
    bytes_per_call = fact.bytes / fact.depth;
    if (fact.point == kNoIndex) give_back();
  }
  void operator()(const CallDecided& fact) {
    running().decided = true;
    if (!fact.outside) give_back();
  }
  void operator()(const RecursionStopped& fact) {
    enter({.depth = fact.depth, .left = fact.left});
    tree.stopped_at = fact.depth;
  }
  void operator()(const AllChecked&) { end(); }
  void operator()(const SupportReplaced&) { end(); }
  void operator()(const Finished&) { end(); }
  void operator()(const auto&) {}

  void enter(TreeCall call) {
    call.parent = tree.open.empty() ? -1 : tree.open.back();
    call.again = call.parent >= 0 && tree.calls[call.parent].decided;
    tree.deepest = std::max(tree.deepest, call.depth);
    tree.open.push_back(static_cast<int>(tree.calls.size()));
    tree.calls.push_back(call);
  }

  TreeCall& running() { return tree.calls[tree.open.back()]; }

  /// The running call returns. If it was its caller's second, the caller returns with it.
  void give_back() {
    for (bool again = true; again && !tree.open.empty(); tree.open.pop_back()) {
      running().open = false;
      again = running().again;
    }
  }
  void end() {
    for (const int i : tree.open) tree.calls[i].open = false;
    tree.open.clear();
  }
};

}  // namespace

bool has_calls(FitTrace trace) {
  return !trace.empty() && std::holds_alternative<CallEntered>(trace.front().step.fact);
}

CallTree call_tree(FitTrace trace, int steps) {
  if (!has_calls(trace)) return {};
  TreeFollower follower;
  for (const auto& entry : trace.first(steps)) std::visit(follower, entry.step.fact);
  follower.tree.bytes = follower.bytes_per_call * static_cast<std::int64_t>(follower.tree.open.size());
  return std::move(follower.tree);
}

}  // namespace snug::lesson
