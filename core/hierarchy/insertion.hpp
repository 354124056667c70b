// Trees built body by body: each is inserted where the sum of all surface areas grows least, and the nodes passed are
// rotated if that makes one smaller. Source: J. Goldsmith, J. Salmon, "Automatic creation of object hierarchies for ray
// tracing", 1987; A. Kensler, "Tree rotations for improving bounding volume hierarchies", 2008.
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
    "volume ← merged from both children",
};

/// No body is inserted deeper than this. Otherwise bodies inside one another would make a chain, and O(n^2) time.
inline constexpr int kDeepestInsertion = 256;

using InsertionFacts = std::vector<std::variant<BodyInserted, Rotated>>;

/// Inserts the bodies in their order. If two children grow alike, it takes the one with fewer bodies, then the first.
/// facts: null, or where the steps' facts are appended. O(n log n) time if the tree comes out balanced, as it does in
/// spread-out scenes; in any case each insertion takes at most kDeepestInsertion steps.
[[nodiscard]] Shape lay_out_by_insertion(const Layout& layout, InsertionFacts* facts = nullptr);

}  // namespace snug::hierarchy
