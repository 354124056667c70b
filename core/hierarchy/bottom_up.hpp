// Trees built from the leaves up: merges the two groups with the smallest common box, again and again.
// Source: S. M. Omohundro, "Five balltree construction algorithms", 1989; B. Walter, K. Bala, M. Kulkarni, K. Pingali,
// "Fast agglomerative clustering for rendering", 2008.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "hierarchy/bounds.hpp"
#include "hierarchy/shape.hpp"
#include "hierarchy/steps.hpp"

namespace snug::hierarchy {

inline constexpr std::array<std::string_view, 5> kBottomUpPseudocode{
    "groups ← each body alone",
    "while there are two groups or more",
    "  a, b ← those whose joint box is smallest",
    "  their parent takes their place",
    "volume ← merged from both children",
};

/// A group's nearest is that with which it has the least half surface area; of equal ones that with fewer bodies, then
/// that of the lower index. Pairs of equal size are merged in the order in which they are found. facts: null, or where
/// the steps' facts are appended. O(n^2) time in all, O(n) memory: enough for some ten thousand bodies.
///
/// Two groups that are each other's nearest stay so whatever else is merged, because boxes only grow. So such pairs are
/// found along a chain of ever nearer neighbours, and sorted afterwards, smallest first. Source: J. P. Benzécri,
/// "Construction d'une classification ascendante hiérarchique par la recherche en chaîne des voisins réciproques",
/// 1982.
[[nodiscard]] Shape lay_out_bottom_up(const Layout& layout, std::vector<NodesMerged>* facts = nullptr);

}  // namespace snug::hierarchy
