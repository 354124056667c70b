// Rotations from angles, with the same bits everywhere: sine and cosine of our own, of sums and products alone.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Both within one unit in the last place for |radians| up to 2^30; farther out the angle is first brought near by
/// whole turns of the double nearest to 2 pi, which costs the digits that so large an angle has not got. radians:
/// finite.
/// Source: W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980, for the reduction; the series
/// are Taylor's.
[[nodiscard]] SineCosine sine_cosine(double radians) noexcept;

/// The plane turned counter-clockwise. Its entries are within one unit in the last place.
[[nodiscard]] Matrix<double, 2> turn(double radians) noexcept;

/// Space turned about an axis through the origin, counter-clockwise for one at whom the axis points. Its entries are
/// within 8u of the exact ones, by way of the quaternion (pose.hpp). axis: any length, finite; the zero vector turns
/// nothing.
[[nodiscard]] Matrix<double, 3> turn(const Vector<double, 3>& axis, double radians) noexcept;

}  // namespace snug
