// The broad phase: finds all pairs of bodies whose axis-aligned boxes overlap, in one of four ways.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 6.3, 7.1 and 7.5.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/aabb.hpp"
#include "hierarchy/broad_phase/pairs_found.hpp"
#include "hierarchy/broad_phase/sweep_and_prune.hpp"

namespace snug::hierarchy {

enum class PairSearch : std::uint8_t {
  kSweepAndPrune,  // only those whose intervals overlap along the axis on which the boxes spread most
  kTree,           // a tree of boxes against itself
  kAllPairs,       // each against each
  kGrid,           // only boxes that reach into the same cell of a grid
};
inline constexpr std::array<std::string_view, 4> kPairSearchNames{"sweep_and_prune", "tree", "all_pairs", "grid"};

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

/// Touching boxes overlap. The pairs come by rising a, then b, the same from every search. sweep: null, or the last
/// frame's order, which a sweep begins from and replaces. seen: null, or where each pair of bodies whose own boxes are
/// compared is appended.
[[nodiscard]] PairsFound broad_phase(std::span<const Aabb<double, 3>> boxes, PairSearch search,
                                     SweepOrder* sweep = nullptr, std::vector<BodyPair>* seen = nullptr);

}  // namespace snug::hierarchy
