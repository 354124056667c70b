// A smooth kind of volume, as its own header would have it: what follows from a support mapping alone is tested on it.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "geometry/core.hpp"
#include "geometry/vector.hpp"
#include "number/dyadic.hpp"

namespace snug {

/// All p between the planes across the axis through its ends a and b, which are two points, and no farther than radius
/// from it. In 2-D a rectangle.
template <class Scalar, int Dim>
struct Cylinder {
  Vector<Scalar, Dim> a = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> b = Vector<Scalar, Dim>::UnitX();
  Scalar radius = 0;  // >= 0
  static constexpr std::array<std::string_view, 3> kFields{"a", "b", "radius"};
  static auto tie(auto& own) { return std::tie(own.a, own.b, own.radius); }
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Cylinder<Scalar, Dim>& cylinder) {
  const double length = difference(cylinder.b, cylinder.a).norm();
  const auto r = static_cast<double>(cylinder.radius);
  return (Dim == 2 ? 2 * r : std::numbers::pi * r * r) * length;
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Cylinder<Scalar, Dim>& cylinder) {
  return cylinder.a;
}

/// The operations that its support mapping has taken so far.
struct CylinderWork {
  std::int64_t dot_products = 0, square_roots = 0;
};
inline CylinderWork cylinder_work;

/// A point of a rim. Across the axis twice: where the direction is nearly along it, once leaves mostly rounding.
template <class Scalar, int Dim>
[[nodiscard]] Vector<double, Dim> core_support(const Cylinder<Scalar, Dim>& cylinder, const Vector<Scalar, Dim>& origin,
                                               const Vector<double, Dim>& direction) {
  const Vector<double, Dim> axis = difference(cylinder.b, cylinder.a).normalized();
  const double along = direction.dot(axis);
  const Vector<double, Dim> end = difference(along > 0 ? cylinder.b : cylinder.a, origin);
  Vector<double, Dim> across = direction - axis * along;
  const double length = across.norm();
  cylinder_work.dot_products += 3, cylinder_work.square_roots += 2;
  if (!(length > 0)) return end;
  across /= length;
  across -= axis * across.dot(axis);
  cylinder_work.dot_products += 1;
  return end + static_cast<double>(cylinder.radius) * across;
}

template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Cylinder<Scalar, Dim>& cylinder,
                            const std::type_identity_t<Vector<Scalar, Dim>>& point) {
  Dyadic along, axis, square;
  for (int i = 0; i < Dim; ++i) {
    const Dyadic start = static_cast<double>(cylinder.a[i]);
    const Dyadic p = Dyadic(static_cast<double>(point[i])) - start;
    const Dyadic e = Dyadic(static_cast<double>(cylinder.b[i])) - start;
    along += p * e, axis += e * e, square += p * p;
  }
  const Dyadic radius = static_cast<double>(cylinder.radius);
  return along.sign() >= 0 && along <= axis && (square - radius * radius) * axis <= along * along;
}

template <class Scalar, int Dim>
[[nodiscard]] Cylinder<Scalar, Dim> moved(const Cylinder<Scalar, Dim>& cylinder, const Vector<Scalar, Dim>& by) {
  return {cylinder.a + by, cylinder.b + by, cylinder.radius};
}
template <class Scalar, int Dim>
[[nodiscard]] Cylinder<Scalar, Dim> turned(const Cylinder<Scalar, Dim>& cylinder, const Matrix<Scalar, Dim>& rotation) {
  const Vector<Scalar, Dim> middle = (cylinder.a + cylinder.b) / 2;
  return {middle + rotation * (cylinder.a - middle), middle + rotation * (cylinder.b - middle), cylinder.radius};
}

}  // namespace snug
