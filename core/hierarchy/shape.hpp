// A tree's shape, before its nodes have volumes.
#pragma once

#include <array>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::hierarchy {

/// The same as in Node.
struct ShapeNode {
  Index first = 0;
  Index count = 0;
};

/// The same as in Tree.
struct Shape {
  std::vector<ShapeNode> nodes;
  std::vector<Index> bodies;
};

/// The shape of a tree of pairs: group i is body i if i < n, and otherwise has the children pairs[i - n]. root: a
/// group, or kNoIndex if there are no bodies.
[[nodiscard]] Shape shape_of(const std::vector<std::array<Index, 2>>& pairs, Index bodies, Index root);

}  // namespace snug::hierarchy
