#include "lesson/subjects/tree/tree_pair.hpp"

#include <algorithm>

#include "hierarchy/traverse_pair.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects/tree/tree_merge.hpp"
#include "query/overlap/overlaps.hpp"

namespace snug::lesson {
namespace {

/// Follows two trees against each other by the steps alone.
struct PairFollower {
  const Forest &own, &copy;
  PairState now = {};

  void operator()(const auto&) {}
  void operator()(const hierarchy::PairTested& fact) {
    const NodePair pair = fact.bodies ? NodePair{leaf_of(fact.a), leaf_of(fact.b)} : NodePair{fact.a, fact.b};
    now.now = pair, now.apart = !fact.overlap;
    std::erase(now.waiting, pair);
    ++now.visited;
    ++(fact.bodies ? now.box_tests : now.node_tests);
    if (fact.bodies && fact.overlap) now.found.push_back({fact.a, fact.b});
    if (fact.bodies) return;
    if (fact.overlap) open_below(pair);
    else now.left_out += static_cast<std::int64_t>(own.at(pair[0]).boxes.size() * copy.at(pair[1]).boxes.size());
  }
  void operator()(const hierarchy::Done&) { now.now.reset(); }

  /// Every child of one with every child of the other; a leaf stands for itself.
  void open_below(const NodePair& pair) {
    const auto below = [](const Forest& forest, Index node) {
      const auto& children = forest.at(node).children;
      return forest.at(node).divides() ? std::vector<Index>{children[1], children[0]} : std::vector<Index>{node};
    };
    for (const Index a : below(own, pair[0]))
      for (const Index b : below(copy, pair[1])) now.waiting.push_back({a, b});
  }

  [[nodiscard]] Index leaf_of(Index box) const {
    for (const Index i : own.there())
      if (!own.at(i).divides() && own.at(i).boxes.front() == box) return i;
    return kNoIndex;
  }
};

}  // namespace

std::vector<Box2> moved_by(const QueryPlaces& query, std::span<const Box2> boxes) {
  const Point2 way = query.at[1] - query.at[0];
  std::vector<Box2> moved;
  for (const Box2& box : boxes) moved.push_back({box.min + way, box.max + way});
  return moved;
}

TreePairing pair_with_copy(const TreeOfBoxes& tree, std::span<const Box2> boxes, const QueryPlaces& query,
                           TreeTrace& trace) {
  TreePairing pairing{.moved = moved_by(query, boxes), .copy = {}, .states = {}};
  const TreeOfBoxes copy = refitted(tree, pairing.moved);
  Recorder<hierarchy::Step> recorder;
  hierarchy::overlapping_pairs(
      tree, boxes, copy, pairing.moved, [](Index, Index) {}, recorder);
  for (const auto& [step, counts] : recorder.entries)
    if (const auto* tested = std::get_if<hierarchy::PairTested>(&step.fact))
      trace.push_back({TreeStep{step.line, *tested}, counts});
    else trace.push_back({TreeStep{step.line, std::get<hierarchy::Done>(step.fact)}, counts});
  const Forest own = forest_of(tree, boxes);
  pairing.copy = forest_of(copy, pairing.moved);
  PairFollower follower{own, pairing.copy};
  follower.now.waiting.push_back({0, 0});
  pairing.states = {follower.now};
  for (const auto& entry : trace) {
    std::visit(follower, entry.step.fact);
    pairing.states.push_back(follower.now);
  }
  return pairing;
}

std::vector<NodePair> pairs_one_by_one(std::span<const Box2> boxes, const QueryPlaces& query) {
  const std::vector<Box2> moved = moved_by(query, boxes);
  std::vector<NodePair> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < moved.size(); ++k)
      if (query::overlaps(boxes[i], moved[k])) found.push_back({static_cast<Index>(i), static_cast<Index>(k)});
  return found;
}

std::string small(std::string name) {
  for (char& letter : name)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return name;
}

std::string pair_name(const Forest& own, const Forest& copy, const NodePair& pair) {
  const auto& all = own.at(own.roots.front()).boxes;
  const auto name = [&](const Forest& forest, int side) -> std::string {
    const auto& boxes = forest.at(pair[side]).boxes;
    if (boxes.size() == all.size()) return side == 0 ? "the root" : "the copy's root";
    return side == 0 ? node_name(boxes, all.size()) : small(node_name(boxes, all.size()));
  };
  if (pair == NodePair{own.roots.front(), copy.roots.front()}) return "the roots";
  return name(own, 0) + " and " + name(copy, 1);
}

std::string pair_names(const std::vector<NodePair>& boxes) {
  std::vector<std::string> names;
  for (const NodePair& pair : boxes) names.push_back(box_name(pair[0]) + " and " + small(box_name(pair[1])));
  return listed(names, ", and ");
}

}  // namespace snug::lesson
