// Samples of a set's points, for measurements that would take too long on all of them.
#pragma once

#include "geometry/generate.hpp"
#include "geometry/point_set.hpp"

namespace snug::cost {

/// n of the points in their order, one from each of n equal parts of it, because a mesh's neighbours are often near
/// each other in the order. All points, if there are no more than n. n: at least 1.
[[nodiscard]] AnyPointSet sample(const AnyPointSet& points, Index n, std::uint64_t seed);

/// The same as a stream. points: more than n; they must outlive the stream.
[[nodiscard]] PointStream sample_stream(const AnyPointSet& points, Index n, std::uint64_t seed);

}  // namespace snug::cost
