// Bodies in a tree and in a field, many of which touch a plane of the frustum that they are culled by: each verdict is
// held to exact arithmetic.
#pragma once

#include "core/query/query_families.hpp"
#include "geometry/random.hpp"

namespace snug::test {

/// Adds the culling of 12 AABBs or spheres by a tree of any of the four builders, and once more after half of them
/// moved and the tree was refitted. A pair that the tree does not find, or finds twice, makes a wrong answer as well.
template <class Scalar, int Dim>
void add_tree(QueryTally& tally, Random& random);

/// Adds the culling of a field of 80 boxes in each of its six ways.
void add_field(QueryTally& tally, Random& random);

}  // namespace snug::test
