// A tree as it grows: after each step of its construction, a few trees, or one whose branches are still to be divided.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/steps.hpp"
#include "hierarchy/tree.hpp"
#include "lesson/subjects/tree/node_volume.hpp"

namespace snug::lesson {

/// A node of it: from the root down numbered as in hierarchy::Tree, else by groups, the boxes first
/// (hierarchy/steps.hpp).
struct Branch {
  std::array<Index, 2> children{kNoIndex, kNoIndex};
  std::vector<Index> boxes;  // those below, rising
  Box2 box;                  // around them
  NodeVolume volume;         // that of the node: the box, or another around its children's
  [[nodiscard]] bool divides() const { return children[0] != kNoIndex; }
};

struct Forest {
  std::vector<Branch> branches;
  std::vector<Index> roots;
  [[nodiscard]] const Branch& at(Index i) const { return branches[i]; }
  /// The branches that are there, parents before children, left before right.
  [[nodiscard]] std::vector<Index> there() const;
  /// The branch whose child it is; kNoIndex for a root.
  [[nodiscard]] Index parent_of(Index i) const;
};

using TreeOfBoxes = hierarchy::Tree<Box2>;

/// The whole tree, with the volumes of a kind that its nodes have.
[[nodiscard]] Forest forest_of(const TreeOfBoxes& tree, std::span<const Box2> boxes, NodeKind kind = NodeKind::kAabb);

/// The expected number of tests once a line meets the root, by the surface-area heuristic (hierarchy/cost.hpp) with the
/// perimeters of the nodes' own volumes. whole: has a single root.
[[nodiscard]] double expected_cost(const Forest& whole);
/// The tests that random lines make in one tree, divided by those that the same lines make in the other.
[[nodiscard]] double tests_of_lines(const Forest& one, const Forest& other);

/// Follows the construction of a tree, step by step.
class Growth {
 public:
  enum class Way {
    kDown,      // from the root
    kUp,        // from the leaves
    kInserting  // box by box
  };
  /// tree: the finished one.
  Growth(Way way, const TreeOfBoxes& tree, std::span<const Box2> boxes, NodeKind kind = NodeKind::kAabb);
  [[nodiscard]] const Forest& forest() const { return now_; }

  void operator()(const hierarchy::SplitChosen& fact);
  void operator()(const hierarchy::NodesMerged& fact);
  void operator()(const hierarchy::BodyInserted& fact);
  void operator()(const hierarchy::Rotated& fact);
  void operator()(const auto&) {}

 private:
  Branch& at(Index i) { return now_.branches[i]; }
  void join(Index made, Index left, Index right);
  void refresh(Index i);

  std::span<const Box2> boxes_;
  NodeKind kind_ = NodeKind::kAabb;
  Forest whole_;  // of a tree from the root down
  Forest now_;
};

}  // namespace snug::lesson
