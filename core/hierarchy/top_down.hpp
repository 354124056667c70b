// Trees built from the root down: all bodies, divided again and again.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 6.2.1; sah.hpp has that of the surface-area heuristic.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "hierarchy/bounds.hpp"
#include "hierarchy/sah.hpp"
#include "hierarchy/shape.hpp"
#include "hierarchy/steps.hpp"

namespace snug::hierarchy {

inline constexpr std::array<std::string_view, 6> kMedianPseudocode{
    "node ← all bodies",
    "few bodies: node is a leaf",
    "axis ← where centres spread most",
    "halve the bodies at the median centre",
    "node's children ← the halves, likewise",
    "volume ← merged from both children",
};

enum class SplitRule : std::uint8_t { kMedian, kSurfaceArea };

/// The facts of the build, in order: prices of splits, splits and leaves.
using TopDownFacts = std::vector<std::variant<SplitsPriced, SplitChosen, LeafMade>>;

/// Bodies are divided by their boxes' centres, or by index if a node's centres are all in one place. The surface-area
/// heuristic (sah.hpp) divides at the cheapest border between 16 bins per axis, which cover the node's centres; from
/// depth 40 on its nodes are split at the median, and become leaves where the median's would, so that no tree is much
/// deeper. most_in_leaf: >= 1. facts: null, or where the steps' facts are appended. O(n log n) time.
[[nodiscard]] Shape lay_out_top_down(const Layout& layout, SplitRule rule, Index most_in_leaf,
                                     TopDownFacts* facts = nullptr);

}  // namespace snug::hierarchy
