// Finds all pairs of boxes that overlap, in three ways.
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
};
inline constexpr std::array<std::string_view, 3> kPairSearchNames{"sweep_and_prune", "tree", "all_pairs"};

inline constexpr std::array<std::string_view, 6> kSweepAndPrunePseudocode{
    "axis ← where the AABBs spread most",      "sort the AABBs by where they begin on it",
    "for each box a, in this order",           "  for each b after it that begins before a ends",
    "    a pair, if they overlap on all axes", "spheres, then the exact test, on each pair",
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

struct PairsFound {
  std::vector<Pair> pairs;    // by rising a, then b; the same for every search
  std::int64_t compared = 0;  // how many pairs of boxes were compared, including the tree's nodes
  int axis = -1;              // the axis along which boxes were sorted; -1: none
};

/// Touching boxes overlap.
/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 7.5.
[[nodiscard]] PairsFound overlapping_pairs(std::span<const Aabb<double, 3>> boxes, PairSearch search);

}  // namespace snug::scene
