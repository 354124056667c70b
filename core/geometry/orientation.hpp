// On which side a point lies: exact signs of determinants, whatever the coordinates.
// Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997,
// for the filters; what they leave open is decided with integers (usually) or with numbers of any length.
#pragma once

#include <cmath>

#include "geometry/tolerance.hpp"
#include "geometry/vector.hpp"

namespace snug {

// All coordinates are finite doubles; those of float points are cast, which is exact.

namespace detail {
using P2 = const Vector<double, 2>&;
using P3 = const Vector<double, 3>&;
template <int Dim>
using P = const Vector<double, Dim>&;

int cross_sign_exact(P2 a, P2 b, P2 c, P2 d) noexcept;
int orient3d_in_doubt(P3 a, P3 b, P3 c, P3 d) noexcept;
template <int Dim>
int dot_sign_exact(P<Dim> a, P<Dim> b, P<Dim> c, P<Dim> d) noexcept;

/// The sign of value if it is certain, else 0. error_bound: bounds value's error. If either has overflowed, no sign is
/// certain.
[[nodiscard]] inline int certain_sign(double value, double error_bound) noexcept {
  if (value > error_bound) return 1;
  return value < -error_bound ? -1 : 0;
}
}  // namespace detail

/// -1, 0 or +1: the sign of (b - a) x (d - c). It is +1 if d lies farther to the left of the line from a to b than c.
[[nodiscard]] inline int cross_sign(const Vector<double, 2>& a, const Vector<double, 2>& b, const Vector<double, 2>& c,
                                    const Vector<double, 2>& d) noexcept {
  const double left = (b[0] - a[0]) * (d[1] - c[1]);
  const double right = (b[1] - a[1]) * (d[0] - c[0]);
  const int sign = detail::certain_sign(left - right, tolerance::kTwoProducts * (std::abs(left) + std::abs(right)) +
                                                          tolerance::kLostToUnderflow);
  return sign != 0 ? sign : detail::cross_sign_exact(a, b, c, d);
}

/// +1 if a, b, c turn counter-clockwise, 0 if they lie on a line, else -1.
[[nodiscard]] inline int orient2d(const Vector<double, 2>& a, const Vector<double, 2>& b,
                                  const Vector<double, 2>& c) noexcept {
  return cross_sign(a, b, a, c);
}

/// +1 if d lies on the side from which a, b, c are seen counter-clockwise, 0 if the four lie in a plane, else -1.
[[nodiscard]] inline int orient3d(const Vector<double, 3>& a, const Vector<double, 3>& b, const Vector<double, 3>& c,
                                  const Vector<double, 3>& d) noexcept {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double x1 = by * cz, x2 = bz * cy, y1 = bz * cx, y2 = bx * cz, z1 = bx * cy, z2 = by * cx;
  const double value = dx * (x1 - x2) + dy * (y1 - y2) + dz * (z1 - z2);
  const double size = std::abs(dx) * (std::abs(x1) + std::abs(x2)) + std::abs(dy) * (std::abs(y1) + std::abs(y2)) +
                      std::abs(dz) * (std::abs(z1) + std::abs(z2));
  const double reach = 1 + std::abs(dx) + std::abs(dy) + std::abs(dz);
  const double error_bound = tolerance::kSixTripleProducts * size + tolerance::kLostToUnderflow * reach;
  const int sign = detail::certain_sign(value, error_bound);
  return sign != 0 ? sign : detail::orient3d_in_doubt(a, b, c, d);
}

/// -1, 0 or +1: the sign of (b - a) . (d - c). It is +1 if d lies farther than c in the direction from a to b.
template <int Dim>
[[nodiscard]] int dot_sign(const Vector<double, Dim>& a, const Vector<double, Dim>& b, const Vector<double, Dim>& c,
                           const Vector<double, Dim>& d) noexcept {
  double value = 0, size = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double product = (b[axis] - a[axis]) * (d[axis] - c[axis]);
    value += product;
    size += std::abs(product);
  }
  const int sign = detail::certain_sign(value, tolerance::kThreeProducts * size + tolerance::kLostToUnderflow);
  return sign != 0 ? sign : detail::dot_sign_exact<Dim>(a, b, c, d);
}

/// A point's projection along a coordinate axis: its other two coordinates, in cyclic order.
[[nodiscard]] inline Vector<double, 2> shadow(const Vector<double, 3>& p, int axis) noexcept {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// The first axis along which the projections of the three points do not lie on a line; kNoIndex if the points
/// themselves do.
[[nodiscard]] inline int shadow_axis(const Vector<double, 3>& a, const Vector<double, 3>& b,
                                     const Vector<double, 3>& c) noexcept {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(shadow(a, axis), shadow(b, axis), shadow(c, axis)) != 0) return axis;
  return kNoIndex;
}

/// Whether the three lie on a line.
[[nodiscard]] inline bool collinear(const Vector<double, 3>& a, const Vector<double, 3>& b,
                                    const Vector<double, 3>& c) noexcept {
  return shadow_axis(a, b, c) == kNoIndex;
}

}  // namespace snug
