// Trees from the leaves up: the two groups that make the smallest box together become one, again and again.
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
    "groups ← each body alone",         "while there are two groups or more", "  a, b ← whose box together is smallest",
    "  their parent takes their place", "volume ← merged of both children",
};

/// Pairs are compared by half the surface of their box; of equals those of the fewest bodies, then of the least index.
/// facts: null, or what is told is added to it. O(n^2) time on the whole, O(n) memory: for some ten thousand bodies.
///
/// Two groups that are each other's nearest stay so whatever else is merged, for a box only grows: such pairs are found
/// along a chain of ever nearer neighbours, and afterwards sorted into the order in which the smallest goes first.
/// Source: J. P. Benzécri, "Construction d'une classification ascendante hiérarchique par la recherche en chaîne des
/// voisins réciproques", 1982.
[[nodiscard]] Shape lay_out_bottom_up(const Layout& layout, std::vector<NodesMerged>* facts = nullptr);

}  // namespace snug::hierarchy
