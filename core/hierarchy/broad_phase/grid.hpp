// A uniform grid over boxes: only boxes that reach into the same cell are compared.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 7.1.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/aabb.hpp"
#include "hierarchy/broad_phase/pairs_found.hpp"

namespace snug::hierarchy {

/// A box that reaches into more cells than this is put into none: it is compared with every other box instead.
inline constexpr std::int64_t kMostCellsOfBox = 512;

inline constexpr std::array<std::string_view, 6> kGridPairsPseudocode{
    "cell ← twice the mean extents of the AABBs",
    "put each AABB into every cell that it reaches into",
    "for each cell",
    "  for each two AABBs in it, if not compared yet",
    "    a pair, if they overlap on all axes",
    "spheres, then the exact test, on each pair",
};

/// Its cells are counted from the least place of any box.
struct Grid {
  Vector<double, 3> origin = Vector<double, 3>::Zero(), cell = Vector<double, 3>::Ones();
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(const Vector<double, 3>& place) const;
};

/// The grid that pairs_by_grid uses. boxes: n >= 1.
[[nodiscard]] Grid grid_of(std::span<const Aabb<double, 3>> boxes);

/// seen: null, or where each pair that is compared is appended.
[[nodiscard]] PairsFound pairs_by_grid(std::span<const Aabb<double, 3>> boxes, std::vector<BodyPair>* seen);

}  // namespace snug::hierarchy
