// Sweep and prune: sorts boxes along one axis, and compares only those whose intervals on it overlap.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 7.5.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/aabb.hpp"
#include "hierarchy/broad_phase/pairs_found.hpp"

namespace snug::hierarchy {

/// The code has no active list: it compares each AABB with those after it that begin before it ends. If there is no
/// last order, it sorts by merging.
inline constexpr std::array<std::string_view, 7> kSweepAndPrunePseudocode{
    "axis ← where the AABBs spread most",
    "sort the last frame's order by insertion",
    "for each AABB a, in this order",
    "  drop those from the active list that end before a",
    "  compare a with each b that is left in the list",
    "  put a into the active list",
    "spheres, then the exact test, on each pair",
};

/// The bodies by where their AABBs begin along an axis, as the last sweep left them: the next begins from there.
struct SweepOrder {
  int axis = -1;  // none yet
  std::vector<Index> bodies;
};

/// sweep: the last frame's order, which is replaced. seen: null, or where each pair that is compared is appended.
[[nodiscard]] PairsFound sweep_and_prune(std::span<const Aabb<double, 3>> boxes, SweepOrder& sweep,
                                         std::vector<BodyPair>* seen);

}  // namespace snug::hierarchy
