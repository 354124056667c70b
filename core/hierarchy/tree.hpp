// The bounding-volume hierarchy: a binary tree whose leaves have bodies, and whose nodes each have a volume around
// everything below. Source: C. Ericson, "Real-Time Collision Detection", 2005, 6.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::hierarchy {

/// A leaf's bodies are the count ones from first on in Tree::bodies, count >= 1. An inner node's left child is
/// Tree::nodes[first], its right child is the next one, and count is 0.
template <class VolumeType>
struct Node {
  VolumeType volume;
  Index first = 0;
  Index count = 0;

  [[nodiscard]] bool is_leaf() const { return count > 0; }
};

/// A body is an index into the list of volumes that the tree was built from, which the tree does not keep.
template <class VolumeType>
struct Tree {
  std::vector<Node<VolumeType>> nodes;  // the root first, children after their parent; empty if there are no bodies
  std::vector<Index> bodies;            // each once; those below a node are contiguous, in a leaf by rising index

  /// All bodies below a node. O(depth) time.
  [[nodiscard]] std::span<const Index> bodies_below(Index node) const {
    const auto at = [&](Index i) -> const Node<VolumeType>& { return nodes[i]; };
    Index first = node, last = node;
    while (!at(first).is_leaf()) first = at(first).first;
    while (!at(last).is_leaf()) last = at(last).first + 1;
    const auto begin = static_cast<std::size_t>(at(first).first),
               end = static_cast<std::size_t>(at(last).first + at(last).count);
    return std::span(bodies).subspan(begin, end - begin);
  }
  /// The largest number of nodes on a path from the root to a leaf.
  [[nodiscard]] int depth() const {
    std::vector<int> depths(nodes.size(), 1);
    int most = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      most = std::max(most, depths[i]);
      if (nodes[i].is_leaf()) continue;
      const std::size_t left = nodes[i].first;
      depths[left] = depths[left + 1] = depths[i] + 1;
    }
    return most;
  }
};

/// What a traversal cost, to compare with one test for each body, or for each pair.
struct Counts {
  std::int64_t nodes_visited = 0;
  std::int64_t node_tests = 0;  // tests of nodes' volumes
  std::int64_t body_tests = 0;  // tests of bodies' own volumes

  [[nodiscard]] std::int64_t volume_tests() const { return node_tests + body_tests; }
};

}  // namespace snug::hierarchy
