// Where Quickhull starts in space: points that span as many dimensions as the whole set does.
#pragma once

#include <vector>

#include "geometry/point_set.hpp"

namespace snug::fit {

/// Up to four points that are affinely independent, exactly; fewer just where all points lie in a plane (three), on a
/// line (two) or in one place (one). The first two are farthest apart of those extreme along an axis, the third is far
/// from their line, the fourth far from the plane: the farthest but for rounding. Of points in one place the first is
/// taken. Three passes; a fourth or fifth where rounding cannot tell the set from a flat one.
template <class Scalar>
[[nodiscard]] std::vector<Index> spanning_simplex(PointSpan<Scalar, 3> points);

}  // namespace snug::fit
