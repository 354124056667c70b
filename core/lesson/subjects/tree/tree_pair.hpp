// Two trees against each other: the second is a copy of the first, with all that is in it moved from Q to R.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lesson/subjects/tree/tree_methods.hpp"

namespace snug::lesson {

/// A node of either tree, or a box of either.
using NodePair = std::array<Index, 2>;

/// How far two trees have been tested against each other.
struct PairState {
  std::vector<NodePair> waiting;  // the open pairs of nodes; the last is the next one
  std::optional<NodePair> now;    // the nodes that the last step tested, or whose boxes it tested
  bool apart = false;             // what it found
  std::vector<NodePair> found;    // the pairs of boxes that overlap
  std::int64_t visited = 0, node_tests = 0, box_tests = 0;
  std::int64_t left_out = 0;  // pairs of boxes below nodes that are apart
  [[nodiscard]] std::int64_t tests() const { return node_tests + box_tests; }
};

struct TreePairing {
  std::vector<Box2> moved;  // the copy's boxes
  Forest copy;
  std::vector<PairState> states;  // after each step
  [[nodiscard]] const std::vector<NodePair>& found() const { return states.back().found; }
};

/// Tests a tree against its copy. trace: where the steps are appended.
[[nodiscard]] TreePairing pair_with_copy(const TreeOfBoxes& tree, std::span<const Box2> boxes, const QueryPlaces& query,
                                         TreeTrace& trace);
/// The same pairs, found by testing every pair of boxes, by the first box and then by the second.
[[nodiscard]] std::vector<NodePair> pairs_one_by_one(std::span<const Box2> boxes, const QueryPlaces& query);
/// The boxes of the copy.
[[nodiscard]] std::vector<Box2> moved_by(const QueryPlaces& query, std::span<const Box2> boxes);

/// "BDE and fg", the copy's in small letters; "the roots".
[[nodiscard]] std::string pair_name(const Forest& own, const Forest& copy, const NodePair& pair);
/// "B and f", "B and f, and C and f".
[[nodiscard]] std::string pair_names(const std::vector<NodePair>& boxes);
/// In small letters, as the copy is named.
[[nodiscard]] std::string small(std::string name);

}  // namespace snug::lesson
