// Quickhull's first simplex in space: points that span as many dimensions as the whole set does.
// Source: D. Gregorius, "Implementing QuickHull", Game Developers Conference, 2014, for the choice of the four points;
// here their independence is decided exactly.
#pragma once

#include <vector>

#include "geometry/point_set.hpp"

namespace snug::fit {

/// Four points that are affinely independent, exactly; fewer only if all points lie in a plane (three), on a line (two)
/// or in one place (one). The first two are the farthest apart of the points that are extreme along an axis, the third
/// is the farthest from their line, the fourth the farthest from the plane, all but for rounding. Of coincident points,
/// the first is taken. Three passes; a fourth or fifth if rounding cannot tell the set from a flat one.
template <class Scalar>
[[nodiscard]] std::vector<Index> spanning_simplex(PointSpan<Scalar, 3> points);

}  // namespace snug::fit
