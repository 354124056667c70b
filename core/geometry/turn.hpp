// Rotations from angles, with the same bits everywhere, because sine and cosine are made only of sums and products.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Both within one unit in the last place for |radians| up to 2^30; larger angles are first reduced by
/// multiples of the double nearest to 2 pi, whose error is below the resolution of so large an angle. radians:
/// finite.
/// Source: W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980, for the reduction; the series
/// are Taylor's.
[[nodiscard]] SineCosine sine_cosine(double radians) noexcept;

/// The counter-clockwise rotation of the plane. Its entries are within one unit in the last place.
[[nodiscard]] Matrix<double, 2> turn(double radians) noexcept;

/// The rotation of space about an axis through the origin, counter-clockwise as seen from the axis's tip. Its entries
/// are within 8u of the exact ones, by way of the quaternion (pose.hpp). axis: any length, finite; the zero vector
/// gives no rotation.
[[nodiscard]] Matrix<double, 3> turn(const Vector<double, 3>& axis, double radians) noexcept;

}  // namespace snug
