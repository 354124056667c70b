// A smooth kind of volume, as its own header would have it: what follows from a support mapping alone is tested on it.
#pragma once

#include <numbers>
#include <type_traits>

#include "geometry/cylinder.hpp"
#include "number/dyadic.hpp"

namespace snug {

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Cylinder<Scalar, Dim>& cylinder) {
  const double length = difference(cylinder.b, cylinder.a).norm();
  const auto r = static_cast<double>(cylinder.radius);
  return (Dim == 2 ? 2 * r : std::numbers::pi * r * r) * length;
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
