// The surface-area heuristic (SAH): divides a node's bodies where a traversal is expected to be cheapest, at one of 15
// borders between 16 bins along each axis. Below are its three functions, for one node: best_split, which calls
// fill_bins for each axis, then reorder. top_down.cpp calls them, and builds the tree.
// Source: J. Goldsmith, J. Salmon, "Automatic creation of object hierarchies for ray tracing", 1987; I. Wald, "On fast
// construction of SAH-based bounding volume hierarchies", 2007, for the bins.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "hierarchy/bounds.hpp"

namespace snug::hierarchy {

inline constexpr std::array<std::string_view, 6> kSurfaceAreaPseudocode{
    "node ← all bodies",
    "a leaf, if few and no split costs less",
    "for each axis and split between bins",
    "  cost ← 2 + (area n, left + right) / area",
    "split at the least cost; likewise below",
    "volume ← merged from both children",
};

namespace sah {

inline constexpr int kBins = 16, kBorders = kBins - 1;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The bodies whose centres lie between two borders, and the box around them.
struct Bin {
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  Index count = 0;

  void take(const Bin& other) {
    box = united(box, other.box);
    count += other.count;
  }
};
using Bins = std::array<Bin, kBins>;

/// A split at the border between two bins of an axis: the bodies in the bins before the border go left.
struct BinSplit {
  int axis = kNoIndex;  // none if all centres are in one place
  int border = 0;
  double position = 0;  // the border's coordinate in the layout
  Index left = 0;       // bodies
  double cost = kInfinity;
};

/// Divides the range of the centres along an axis evenly, and puts each body into the bin of its centre. centers: the
/// box around the bodies' centres, which is not flat along the axis. So the first bin and the last one are never empty.
[[nodiscard]] Bins fill_bins(const Layout& layout, std::span<const Index> bodies, const Box& centers, int axis);

/// The border of least cost, in tests of a body: 2 for the children's volumes, and each child's bodies times the
/// chance that a line which meets the node meets the child, the ratio of their surface areas. all: the box around the
/// bodies. costs: null, or kBorders for each axis, where the cost at every border is put.
[[nodiscard]] BinSplit best_split(const Layout& layout, std::span<const Index> bodies, const Box& all,
                                  const Box& centers, std::vector<double>* costs);

/// Puts the bodies that go left before those that go right.
void reorder(const Layout& layout, std::span<Index> bodies, const Box& centers, const BinSplit& split);

}  // namespace sah
}  // namespace snug::hierarchy
