#include "geometry/pose.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sphere.hpp"
#include "geometry/turn.hpp"
#include "number/power_of_two.hpp"

namespace snug {

Quaternion normalized(const Quaternion& q) noexcept {
  const double largest = std::max(std::max(std::abs(q.w), std::abs(q.x)), std::max(std::abs(q.y), std::abs(q.z)));
  if (largest == 0) return {};
  const double scale = to_unit_size(largest);
  const double w = scale * q.w, x = scale * q.x, y = scale * q.y, z = scale * q.z;
  const double norm = std::sqrt(w * w + x * x + y * y + z * z);
  return {w / norm, x / norm, y / norm, z / norm};
}

Quaternion quaternion_about(const Vector<double, 3>& axis, double radians) noexcept {
  const Quaternion direction = normalized({0, axis[0], axis[1], axis[2]});
  if (direction.w == 1) return {};  // no axis
  const auto [sine, cosine] = sine_cosine(radians / 2);
  return normalized({cosine, sine * direction.x, sine * direction.y, sine * direction.z});
}

Matrix<double, 3> matrix_of(const Quaternion& q) noexcept {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  Matrix<double, 3> m;
  m << 1 - 2 * (yy + zz), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y),  //
      2 * (q.x * q.y + q.w * q.z), 1 - 2 * (xx + zz), 2 * (q.y * q.z - q.w * q.x),   //
      2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (xx + yy);
  return m;
}

}  // namespace snug
