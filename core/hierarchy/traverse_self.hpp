// Traverses a tree against itself: which of its bodies overlap one another. Its steps name the lines of
// kTreePairsPseudocode (broad_phase/broad_phase.hpp).
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 6.3.
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "hierarchy/steps.hpp"
#include "hierarchy/tree.hpp"
#include "query/overlap/overlaps.hpp"
#include "trace/observer.hpp"

namespace snug::hierarchy {

/// Reports every pair of bodies of one tree whose volumes overlap by query::overlaps, each pair once, in either order.
/// A node with itself needs no test: it opens its children with themselves and with each other. So no two volumes are
/// ever tested twice. volumes: those that the tree was fitted to.
template <class VolumeType, class Report, StepObserver<Step> Observer = Ignore>
Counts overlapping_pairs_within(const Tree<VolumeType>& tree, std::type_identity_t<std::span<const VolumeType>> volumes,
                                Report&& report, Observer&& observe = {}) {
  struct Pair {
    Index a, b;
  };
  Counts counts;
  std::vector<Pair> open;
  const auto test_bodies = [&](Index i, Index j) {
    const bool overlap = query::overlaps(volumes[i], volumes[j]);
    ++counts.body_tests;
    observe(Step{3, PairTested{i, j, true, overlap}});
    if (overlap) report(i, j);
  };
  const auto bodies_of = [&](const Pair& pair) {
    const auto of_a = tree.bodies_below(pair.a), of_b = tree.bodies_below(pair.b);
    for (std::size_t i = 0; i < of_a.size(); ++i)
      for (std::size_t j = pair.a == pair.b ? i + 1 : 0; j < of_b.size(); ++j) test_bodies(of_a[i], of_b[j]);
  };
  const auto open_children = [&](const Pair& pair) {
    const Node<VolumeType>&a = tree.nodes[pair.a], &b = tree.nodes[pair.b];
    const Index first_a = a.is_leaf() ? pair.a : a.first, first_b = b.is_leaf() ? pair.b : b.first;
    for (Index i = a.is_leaf() ? 0 : 1; i >= 0; --i)
      for (Index j = b.is_leaf() ? 0 : 1; j >= 0; --j)
        if (pair.a != pair.b || i <= j) open.push_back({first_a + i, first_b + j});
  };
  if (!tree.nodes.empty()) open.push_back({0, 0});
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    ++counts.nodes_visited;
    const Node<VolumeType>&a = tree.nodes[pair.a], &b = tree.nodes[pair.b];
    const bool single = a.count == 1 && b.count == 1;  // then the volumes are those of the bodies
    if (pair.a != pair.b && !single) {
      const bool overlap = query::overlaps(a.volume, b.volume);
      ++counts.node_tests;
      observe(Step{2, PairTested{pair.a, pair.b, false, overlap}});
      if (!overlap) continue;
    }
    if (a.is_leaf() && b.is_leaf()) bodies_of(pair);
    else open_children(pair);
  }
  observe(Step{2, Done{counts.nodes_visited, counts.volume_tests()}});
  return counts;
}

}  // namespace snug::hierarchy
