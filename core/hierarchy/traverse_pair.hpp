// Traverses two trees at once.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 6.3, the simultaneous descent.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hierarchy/steps.hpp"
#include "hierarchy/tree.hpp"
#include "query/overlap/overlaps.hpp"
#include "trace/observer.hpp"

namespace snug::hierarchy {

inline constexpr std::array<std::string_view, 6> kOverlapPseudocode{
    "open ← both roots, a pair",
    "while a pair is open: test its volumes",
    "  apart: leave out all below",
    "  two leaves: test each body with each",
    "  one leaf: pair it with the other's children",
    "  else open all four pairs of children",
};

/// Reports every pair of bodies, one from each tree, whose volumes overlap by query::overlaps. report(body of a, body
/// of b). The trees may be of different kinds. volumes_a, volumes_b: those that the trees were fitted to.
template <class VolumeA, class VolumeB, class Report, StepObserver<Step> Observer = Ignore>
Counts overlapping_pairs(const Tree<VolumeA>& a, std::type_identity_t<std::span<const VolumeA>> volumes_a,
                         const Tree<VolumeB>& b, std::type_identity_t<std::span<const VolumeB>> volumes_b,
                         Report&& report, Observer&& observe = {}) {
  struct Pair {
    Index a, b;
  };
  Counts counts;
  std::vector<Pair> open;
  const auto bodies_of = [&](const Pair& pair) {
    for (const Index i : a.bodies_below(pair.a))
      for (const Index j : b.bodies_below(pair.b)) {
        const bool overlap = query::overlaps(volumes_a[i], volumes_b[j]);
        ++counts.body_tests;
        observe(Step{3, PairTested{i, j, true, overlap}});
        if (overlap) report(i, j);
      }
  };
  if (!a.nodes.empty() && !b.nodes.empty()) open.push_back({0, 0});
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    ++counts.nodes_visited;
    const Node<VolumeA>& of_a = a.nodes[pair.a];
    const Node<VolumeB>& of_b = b.nodes[pair.b];
    if (of_a.count != 1 || of_b.count != 1) {
      const bool overlap = query::overlaps(of_a.volume, of_b.volume);
      ++counts.node_tests;
      observe(Step{overlap ? 1 : 2, PairTested{pair.a, pair.b, false, overlap}});
      if (!overlap) continue;
    }
    if (of_a.is_leaf() && of_b.is_leaf()) {
      bodies_of(pair);
      continue;
    }
    const Index first_a = of_a.is_leaf() ? pair.a : of_a.first, first_b = of_b.is_leaf() ? pair.b : of_b.first;
    for (Index i = of_a.is_leaf() ? 0 : 1; i >= 0; --i)
      for (Index j = of_b.is_leaf() ? 0 : 1; j >= 0; --j) open.push_back({first_a + i, first_b + j});
  }
  observe(Step{1, Done{counts.nodes_visited, counts.volume_tests()}});
  return counts;
}

}  // namespace snug::hierarchy
