// What a tree is expected to cost whoever traverses it, by the surface-area heuristic.
// Source: J. Goldsmith, J. Salmon, "Automatic creation of object hierarchies for ray tracing", 1987.
#pragma once

#include "hierarchy/bounds.hpp"
#include "hierarchy/tree.hpp"

namespace snug::hierarchy {

/// The expected number of tests, once a line meets the root: a line that meets a convex set meets one inside it with
/// a probability that is the ratio of their surface areas (in the plane, of their perimeters). An inner node costs 2
/// tests, those of its children; a leaf costs one for each of its bodies. By the nodes' axis-aligned boxes; 0 for no
/// nodes.
template <class VolumeType>
[[nodiscard]] double expected_cost(const Tree<VolumeType>& tree) {
  std::vector<VolumeType> volumes;
  for (const auto& node : tree.nodes) volumes.push_back(node.volume);
  const Layout layout = layout_of(std::span<const VolumeType>(volumes));
  const auto size = [&](std::size_t node) {
    const Size own = half_surface_of(layout.boxes[node], layout.dim);
    return half_surface_of(layout.boxes[0], layout.dim).area > 0 ? own.area : own.length;
  };
  double cost = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto tests = static_cast<double>(tree.nodes[i].is_leaf() ? tree.nodes[i].count : 2);
    cost += size(0) > 0 ? tests * (size(i) / size(0)) : tests;
  }
  return cost;
}

}  // namespace snug::hierarchy
