// Trees body by body: each is put where all surfaces together grow least, and what it passed is rotated where that
// makes a node smaller. Source: J. Goldsmith, J. Salmon, "Automatic creation of object hierarchies for ray tracing",
// 1987; A. Kensler, "Tree rotations for improving bounding volume hierarchies", 2008.
#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "hierarchy/bounds.hpp"
#include "hierarchy/shape.hpp"
#include "hierarchy/steps.hpp"

namespace snug::hierarchy {

inline constexpr std::array<std::string_view, 7> kInsertionPseudocode{
    "for each body",
    "  g ← root",
    "  while a child grows less than a pair here",
    "    g ← the child that grows less",
    "  body and g ← children of a new group",
    "  each group above: rotate if it shrinks",
    "volume ← merged of both children",
};

/// No body is put deeper than this. Bodies inside of one another would else make a chain, and all of them O(n^2) time.
inline constexpr int kDeepestInsertion = 256;

using InsertionFacts = std::vector<std::variant<BodyInserted, Rotated>>;

/// Inserts the bodies in their order. Of children that grow alike the one of fewer bodies is taken, then the first.
/// facts: null, or what is told is added to it. O(n log n) time where the tree comes out balanced, as it does of
/// spread-out scenes; O(n) insertions of at most kDeepestInsertion steps in any.
[[nodiscard]] Shape lay_out_by_insertion(const Layout& layout, InsertionFacts* facts = nullptr);

}  // namespace snug::hierarchy
