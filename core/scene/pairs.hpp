// Finds all pairs of boxes that overlap, in four ways.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/aabb.hpp"
#include "scene/world.hpp"

namespace snug::scene {

enum class PairSearch : std::uint8_t {
  kSweepAndPrune,  // along the axis on which the boxes spread most: only those that overlap there are tested on the
                   // others
  kTree,           // a tree of boxes against itself
  kAllPairs,       // each against each
  kGrid,           // only boxes that reach into the same cell of a grid
};
inline constexpr std::array<std::string_view, 4> kPairSearchNames{"sweep_and_prune", "tree", "all_pairs", "grid"};

inline constexpr std::array<std::string_view, 7> kSweepAndPrunePseudocode{
    "axis ← where the AABBs spread most",
    "sort the last frame's order by insertion",
    "for each AABB a, in this order",
    "  drop those from the active list that end before a",
    "  compare a with each b that is left in the list",
    "  put a into the active list",
    "spheres, then the exact test, on each pair",
};
inline constexpr std::array<std::string_view, 6> kTreePairsPseudocode{
    "build a BVH of the AABBs",
    "open ← its root with itself",
    "while a pair of nodes is open: test its AABBs",
    "  leaves: each body with each",
    "  else open their children's pairs",
    "spheres, then the exact test, on each pair",
};
inline constexpr std::array<std::string_view, 4> kAllPairsPseudocode{
    "for each body a",
    "  for each body b after it",
    "    a pair, if their AABBs overlap",
    "spheres, then the exact test, on each pair",
};
inline constexpr std::array<std::string_view, 6> kGridPairsPseudocode{
    "cell ← twice the mean extents of the AABBs",
    "put each AABB into every cell that it reaches into",
    "for each cell",
    "  for each two AABBs in it, if not compared yet",
    "    a pair, if they overlap on all axes",
    "spheres, then the exact test, on each pair",
};

struct PairsFound {
  std::vector<Pair> pairs;    // by rising a, then b; the same for every search
  std::int64_t compared = 0;  // how many pairs of boxes were compared, including the tree's nodes
  int axis = -1;              // the axis along which boxes were sorted; -1: none
  std::int64_t swaps = 0;     // how many neighbours changed places while they were sorted
};

/// Touching boxes overlap. sweep: null, or the last frame's order, which a sweep begins from and replaces. seen: null,
/// or a list that receives each pair of bodies whose own boxes were compared.
/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 7.1 and 7.5.
[[nodiscard]] PairsFound overlapping_pairs(std::span<const Aabb<double, 3>> boxes, PairSearch search,
                                           SweepOrder* sweep = nullptr, std::vector<Pair>* seen = nullptr);

/// A uniform grid over boxes. Its cells are counted from the least place of any box.
struct Grid {
  V3 origin = V3::Zero(), cell = V3::Ones();
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(const V3& place) const;
};

/// The grid that PairSearch::kGrid uses. boxes: n >= 1.
[[nodiscard]] Grid grid_of(std::span<const Aabb<double, 3>> boxes);

}  // namespace snug::scene
