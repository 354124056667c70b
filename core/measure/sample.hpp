// Fewer of a set's points: what is measured on where all of them would take too long.
#pragma once

#include "geometry/generate.hpp"
#include "geometry/point_set.hpp"

namespace snug::cost {

/// n of the points in their order, one from each of n equal parts of it, for a mesh's neighbours stand near each other;
/// all where there are no more. n: at least 1.
[[nodiscard]] AnyPointSet sample(const AnyPointSet& points, Index n, std::uint64_t seed);

/// The same, one after the other. points: more than n, which outlive it.
[[nodiscard]] PointStream sample_stream(const AnyPointSet& points, Index n, std::uint64_t seed);

}  // namespace snug::cost
