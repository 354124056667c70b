// How a tree is laid out, before its nodes have volumes.
#pragma once

#include <array>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::hierarchy {

/// As Node has them.
struct ShapeNode {
  Index first = 0;
  Index count = 0;
};

/// As Tree has them.
struct Shape {
  std::vector<ShapeNode> nodes;
  std::vector<Index> bodies;
};

/// The shape of groups that have two groups below them, down to single bodies: group i is body i where i < n, else it
/// has the children pairs[i - n]. root: a group; kNoIndex: there are no bodies.
[[nodiscard]] Shape shape_of(const std::vector<std::array<Index, 2>>& pairs, Index bodies, Index root);

}  // namespace snug::hierarchy
