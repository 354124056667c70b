// Traverses a tree from the root down, skipping what need not be visited. Source: C. Ericson, Real-Time Collision
// Detection, 2005, 6.3; nodes that are hit wait on a stack, so that of two children the one opened last is taken first.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hierarchy/steps.hpp"
#include "hierarchy/tree.hpp"
#include "trace/observer.hpp"

namespace snug::hierarchy {

inline constexpr std::array<std::string_view, 6> kTraversePseudocode{
    "open ← root",
    "while a node is open: test its volume",
    "  outside: leave out all below",
    "  inside: take all below, untested",
    "  leaf: test each body's volume",
    "  else open both children",
};

/// The node or body whose volume is tested.
struct Place {
  Index index = 0;  // the node's or the body's
  bool is_body = false;
};

/// A visitor's answer about a volume. It may change the state, a copy of its parent's that is passed on to what is
/// below, for example a mask of the planes that still matter. It may also take the place, to remember something there.
template <class Visit, class VolumeType, class State>
[[nodiscard]] Answer ask(Visit& visit, const VolumeType& volume, State& state, Place place) {
  if constexpr (std::is_invocable_v<Visit&, const VolumeType&, State&, Place>) return visit(volume, state, place);
  else return visit(volume, state);
}

/// Reports every body that is not pruned, with its answer; everything below an accepted node is kAccept, without
/// a test. visit(volume, state [, place]) -> Answer: for a node kPrune or kAccept only if that is right for
/// everything below it; for a body kDescend also means that it is not pruned, and is reported. A leaf of one body
/// is not tested itself. report(body, answer). volumes: those that the tree fits. Bodies come in the tree's
/// order.
///
/// Frustum culling is a visit that classifies: kPrune if outside, kAccept if inside, kDescend if it intersects.
template <class VolumeType, class State, class Visit, class Report, StepObserver<Step> Observer = Ignore>
Counts traverse(const Tree<VolumeType>& tree, std::type_identity_t<std::span<const VolumeType>> volumes,
                const State& root, Visit&& visit, Report&& report, Observer&& observe = {}) {
  struct Open {
    Index node;
    State state;
  };
  Counts counts;
  std::vector<Open> open;
  if (!tree.nodes.empty()) open.push_back({0, root});
  while (!open.empty()) {
    Open now = open.back();
    open.pop_back();
    ++counts.nodes_visited;
    const Node<VolumeType>& node = tree.nodes[now.node];
    if (node.count != 1) {
      const Answer answer = ask(visit, node.volume, now.state, {now.node, false});
      ++counts.node_tests;
      observe(Step{answer == Answer::kPrune    ? 2
                   : answer == Answer::kAccept ? 3
                   : node.is_leaf()            ? 4
                                               : 5,
                   NodeVisited{now.node, answer}});
      if (answer == Answer::kPrune) continue;
      if (answer == Answer::kAccept) {
        for (const Index body : tree.bodies_below(now.node)) report(body, Answer::kAccept);
        continue;
      }
    }
    if (!node.is_leaf()) {
      open.push_back({node.first + 1, now.state});
      open.push_back({node.first, now.state});
      continue;
    }
    for (const Index body : tree.bodies_below(now.node)) {
      State state = now.state;
      const Answer answer = ask(visit, volumes[body], state, {body, true});
      ++counts.body_tests;
      observe(Step{4, BodyTested{body, answer}});
      if (answer != Answer::kPrune) report(body, answer);
    }
  }
  observe(Step{1, Done{counts.nodes_visited, counts.volume_tests()}});
  return counts;
}

// ---- a ray

inline constexpr std::array<std::string_view, 6> kFirstHitPseudocode{
    "open ← root; best ← none",
    "while a node is open: take the last",
    "  beyond the best: leave it out",
    "  leaf: best ← nearest of its bodies",
    "  else test both children's volumes",
    "  open those hit, the nearer one last",
};

/// Which of two children that are both hit is taken first. kFar shows what the order is worth.
enum class ChildOrder : std::uint8_t { kNear, kFar };

/// Whether the right one of two children is taken first; of two at the same t the left one is.
template <class Scalar>
[[nodiscard]] bool is_right_first(ChildOrder order, Scalar left, Scalar right) {
  return order == ChildOrder::kNear ? right < left : left < right;
}

template <class Scalar>
struct Hit {
  Index body = kNoIndex;  // kNoIndex: none was hit
  Scalar t = 0;
  Counts counts;
};

/// The body that is hit first; of several at the same t the one of the least index. hit(volume) ->
/// std::optional<Scalar>: the t of the hit; a node's must be no later than that of anything in it (as query::ray_enters
/// guarantees for boxes). order: a ChildOrder, or right_first(node, t of its left child, t of its right one) -> bool,
/// which is asked at each node whose children are both hit. Whatever the order, the same body is found.
template <class Scalar, class VolumeType, class HitTest, StepObserver<Step> Observer = Ignore, class Order = ChildOrder>
Hit<Scalar> first_hit(const Tree<VolumeType>& tree, std::type_identity_t<std::span<const VolumeType>> volumes,
                      HitTest&& hit, Observer&& observe = {}, Order&& order = ChildOrder::kNear) {
  struct Open {
    Index node;
    Scalar t;
  };
  Hit<Scalar> best;
  std::vector<Open> open;
  const auto right_first_at = [&](Index node, Scalar left, Scalar right) {
    if constexpr (std::is_invocable_v<Order&, Index, Scalar, Scalar>) return order(node, left, right);
    else return is_right_first(order, left, right);
  };
  const auto is_beyond = [&](Scalar t) { return best.body != kNoIndex && t > best.t; };
  const auto test = [&](Index node) -> std::optional<Scalar> {
    const std::optional<Scalar> t = hit(tree.nodes[node].volume);
    ++best.counts.node_tests;
    observe(Step{4, NodeVisited{node, t ? Answer::kDescend : Answer::kPrune}});
    return t;
  };
  if (!tree.nodes.empty())
    if (const auto t = test(0)) open.push_back({0, *t});
  while (!open.empty()) {
    const Open now = open.back();
    open.pop_back();
    if (is_beyond(now.t)) continue;
    ++best.counts.nodes_visited;
    const Node<VolumeType>& node = tree.nodes[now.node];
    if (!node.is_leaf()) {
      const auto left = test(node.first), right = test(node.first + 1);
      const bool right_first = left && right && right_first_at(now.node, *left, *right);
      if (right && !right_first) open.push_back({node.first + 1, *right});
      if (left) open.push_back({node.first, *left});
      if (right && right_first) open.push_back({node.first + 1, *right});
      continue;
    }
    for (const Index body : tree.bodies_below(now.node)) {
      const std::optional<Scalar> t = hit(volumes[body]);
      ++best.counts.body_tests;
      observe(Step{3, BodyTested{body, t ? Answer::kAccept : Answer::kPrune}});
      if (t && (best.body == kNoIndex || *t < best.t || (*t == best.t && body < best.body))) {
        best.body = body;
        best.t = *t;
      }
    }
  }
  observe(Step{1, Done{best.counts.nodes_visited, best.counts.volume_tests()}});
  return best;
}

}  // namespace snug::hierarchy
