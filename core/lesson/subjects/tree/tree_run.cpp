#include "lesson/subjects/tree/tree_run.hpp"

#include <algorithm>

#include "hierarchy/cost.hpp"

namespace snug::lesson {
namespace {

/// Follows a query through a tree by its steps alone.
struct Follower {
  const TreeRun& run;
  bool first;  // whether it looks for the first box: then a node is tested before it waits
  QueryState now = {};

  [[nodiscard]] const Forest& forest() const { return run.forest(0); }
  Met& of(Index node) { return now.nodes[node]; }
  Met& of_box(Index box) { return now.boxes[box]; }

  void operator()(const auto&) {}
  void operator()(const hierarchy::NodeVisited& fact) {
    ++now.node_tests;
    if (first) return test_before(fact.node, fact.answer != hierarchy::Answer::kPrune);
    take(fact.node);
    const Branch& branch = forest().at(fact.node);
    if (fact.answer == hierarchy::Answer::kPrune) mark(fact.node, Met::kUnder), of(fact.node) = Met::kMissed;
    else if (fact.answer == hierarchy::Answer::kAccept) mark(fact.node, Met::kTaken), of(fact.node) = Met::kMet;
    else if (branch.divides())
      for (const int side : {1, 0}) open(branch.children[side]);
  }
  void operator()(const hierarchy::BodyTested& fact) {
    ++now.box_tests;
    const Index leaf = run.leaf_of(fact.body);
    take(leaf);
    of(leaf) = of_box(fact.body) = fact.answer != hierarchy::Answer::kPrune ? Met::kMet : Met::kMissed;
  }
  void operator()(const hierarchy::Done&) {
    if (run.undecided() != kNoIndex) return;  // both children wait for a choice
    for (const Index beyond : now.waiting) mark(beyond, Met::kUnder);
    now.waiting.clear();
  }

  void open(Index node) { now.waiting.push_back(node), of(node) = Met::kOpen; }

  /// Takes a node from those that wait. What lies before it has been left out: it is beyond the best.
  void take(Index node) {
    while (!now.waiting.empty()) {
      const Index next = now.waiting.back();
      now.waiting.pop_back();
      if (next == node) break;
      mark(next, Met::kUnder);
    }
    of(node) = Met::kMet;
    ++now.visited;
  }

  /// A child is tested when its parent is taken, and waits if the ray meets it; of two, the left one is tested first,
  /// and the order says which is next.
  void test_before(Index node, bool met) {
    const Index parent = forest().parent_of(node);
    if (parent != kNoIndex && of(parent) == Met::kOpen) take(parent);
    if (!met) return mark(node, Met::kUnder), static_cast<void>(of(node) = Met::kMissed);
    open(node);
    const std::size_t count = now.waiting.size();
    if (count < 2 || forest().parent_of(now.waiting[count - 2]) != parent) return;
    const auto& right_first = run.result().right_first;
    if (std::find(right_first.begin(), right_first.end(), parent) == right_first.end())
      std::swap(now.waiting[count - 2], now.waiting[count - 1]);
  }

  /// All below a node, and the node.
  void mark(Index node, Met met) {
    of(node) = met;
    const Branch& branch = forest().at(node);
    if (branch.divides())
      for (const Index child : branch.children) mark(child, met);
    else of_box(branch.boxes.front()) = met;
  }
};

constexpr std::string_view kBuildRule = "top_down_sah";  // of a tree whose boxes move

/// The branch that a fact is about.
struct BranchOf {
  const TreeRun& run;
  Index operator()(const auto& fact) const {
    if constexpr (requires { fact.node; }) return fact.node;
    else return kNoIndex;
  }
  Index operator()(const hierarchy::NodesMerged& fact) const { return fact.merged; }
  Index operator()(const hierarchy::BodyInserted& fact) const { return fact.made; }
  Index operator()(const hierarchy::Rotated& fact) const { return fact.group; }
  Index operator()(const hierarchy::BodyTested& fact) const { return run.leaf_of(fact.body); }
  Index operator()(const hierarchy::PairTested& fact) const { return fact.bodies ? run.leaf_of(fact.a) : fact.a; }
};

}  // namespace

std::vector<Index> QueryState::found() const {
  std::vector<Index> all;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i] == Met::kMet || boxes[i] == Met::kTaken) all.push_back(static_cast<Index>(i));
  return all;
}

TreeRun::TreeRun(std::string_view method, std::vector<Box2> boxes, NodeKind kind)
    : boxes_(std::move(boxes)), nodes_(kind), way_(way_of(method)) {
  tree_ = build_tree(method, boxes_, &trace_);
  follow_growth();
}

TreeRun::TreeRun(std::vector<Box2> boxes, std::span<const HandPair> pairs, NodeKind kind)
    : boxes_(std::move(boxes)), nodes_(kind), way_(Growth::Way::kUp) {
  Growth growth(way_, {}, boxes_);
  auto made = static_cast<Index>(boxes_.size());
  for (const HandPair& pair : pairs) {
    const hierarchy::NodesMerged fact{.merged = made++, .left = pair[0], .right = pair[1], .area = 0};
    growth(fact);
    const Box2& box = growth.forest().at(fact.merged).box;
    trace_.push_back(
        {TreeStep{3, hierarchy::NodesMerged{fact.merged, fact.left, fact.right, (box.max - box.min).sum()}}, {}});
  }
  if (pairs.size() + 1 == boxes_.size()) tree_ = tree_by_hand(pairs, boxes_);
  trace_.push_back({TreeStep{4, hierarchy::Done{made, 0}}, {}});
  by_hand_ = true;
  follow_growth();
}

TreeRun::TreeRun(std::string_view method, std::vector<Box2> boxes, std::string_view rule, const QueryPlaces& query,
                 std::span<const Index> choices)
    : boxes_(std::move(boxes)), first_(finds_first(method)), steered_(method == kRayByHand), query_(query) {
  tree_ = build_tree(rule, boxes_);
  forests_ = {forest_of(tree_, boxes_)};
  if (method == kTwoTrees) {
    pairing_ = pair_with_copy(tree_, boxes_, query, trace_);
    return;
  }
  result_ = run_query(method, query, tree_, boxes_, &trace_, choices);
  follow_query();
}

TreeRun::TreeRun(std::string_view method, std::vector<Box2> boxes, std::span<const Box2> built)
    : boxes_(std::move(boxes)) {
  const TreeOfBoxes old = build_tree(kBuildRule, built);
  before_ = Before{forest_of(old, built), hierarchy::expected_cost(old)};
  if (!merges(method)) {
    tree_ = build_tree(kBuildRule, boxes_, &trace_);
    follow_growth();
    return;
  }
  tree_ = refitted(old, boxes_);
  volumes_ = merge_volumes(method, tree_, boxes_, &trace_);
  trace_.push_back({TreeStep{3, hierarchy::Done{static_cast<std::int64_t>(tree_.nodes.size()), 0}}, {}});
  forests_ = {forest_of(tree_, boxes_)};
  word_ = method == "merge_sphere" ? "circle" : method == "merge_obb" ? "OBB" : "AABB";
}

void TreeRun::follow_growth() {
  Growth growth(way_, tree_, boxes_, nodes_);
  forests_ = {growth.forest()};
  for (const auto& entry : trace_) {
    std::visit(growth, entry.step.fact);
    forests_.push_back(growth.forest());
  }
}

void TreeRun::follow_query() {
  Follower follower{*this, first_};
  follower.now.nodes.assign(tree_.nodes.size(), Met::kNot);
  follower.now.boxes.assign(boxes_.size(), Met::kNot);
  if (!first_) follower.open(0);
  states_ = {follower.now};
  for (const auto& entry : trace_) {
    std::visit(follower, entry.step.fact);
    states_.push_back(follower.now);
  }
}

double TreeRun::cost() const { return cost_of_tree(tree_, boxes_, nodes_); }

Index TreeRun::branch_of(int step) const { return std::visit(BranchOf{*this}, trace_[step].step.fact); }

Index TreeRun::leaf_of(Index box) const {
  for (std::size_t i = 0; i < tree_.nodes.size(); ++i)
    if (tree_.nodes[i].is_leaf() && tree_.bodies[tree_.nodes[i].first] == box) return static_cast<Index>(i);
  return kNoIndex;
}

std::string TreeRun::Where::beside_name(Index branch) const {
  const std::string name = name_before(branch);
  return name == "the root" ? name : (name.size() == 1 ? "box " : "node ") + name;
}

std::string TreeRun::name_of(const Forest& forest, Index branch) const {
  return node_name(forest.at(branch).boxes, boxes_.size());
}

std::vector<Index> TreeRun::candidates(int i) const {
  std::vector<Index> all;
  if (const auto* split = std::get_if<hierarchy::SplitChosen>(&trace_[i].step.fact))
    return forest(i).at(split->node).boxes;
  for (Index box = 0; box < static_cast<Index>(boxes_.size()); ++box) all.push_back(box);
  return all;
}

}  // namespace snug::lesson
