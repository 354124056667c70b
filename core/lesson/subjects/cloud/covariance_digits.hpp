// How many digits of a covariance are right.
#pragma once

#include "geometry/point_set.hpp"
#include "geometry/vector.hpp"

namespace snug::lesson {

/// The decimal digits to which a covariance agrees with that of the points, worked out with twice as many digits as a
/// double has: relative to its largest entry, from 0 to 16. found: in 2-D the rest is 0.
[[nodiscard]] int digits_right(const Matrix<double, 3>& found, const AnyPointSet& points);

}  // namespace snug::lesson
