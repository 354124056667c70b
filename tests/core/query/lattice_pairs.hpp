// Spheres, AABBs and k-DOPs whose numbers are whole: whether two of them overlap is decided in whole numbers.
#pragma once

#include "core/query/query_families.hpp"
#include "geometry/random.hpp"

namespace snug::test {

/// Adds twenty pairs. Hard: they only touch, or no axis of theirs separates them although they are apart.
template <class Scalar, int Dim>
void add_lattice_pairs(QueryTally& tally, Random& random);

}  // namespace snug::test
