// The capsule: a sphere swept along a segment.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/core.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// All p no farther than radius from the segment from a to b, which may be the same point.
template <class Scalar, int Dim>
struct Capsule {
  Vector<Scalar, Dim> a = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> b = Vector<Scalar, Dim>::Zero();
  Scalar radius = 0;  // >= 0
  SNUG_FIELDS(a, b, radius);
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Capsule<Scalar, Dim>& capsule) {
  const double length = (capsule.b.template cast<double>() - capsule.a.template cast<double>()).norm();
  const auto r = static_cast<double>(capsule.radius);
  return Dim == 2 ? r * (std::numbers::pi * r + 2 * length) : std::numbers::pi * r * r * (4.0 / 3.0 * r + length);
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Capsule<Scalar, Dim>& capsule) {
  return capsule.a;
}

/// The core is the segment.
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Capsule<Scalar, Dim>& capsule, const Vector<Scalar, Dim>& origin) {
  return {difference(capsule.a, origin), difference(capsule.b, origin)};
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Capsule<Scalar, Dim>& capsule) {
  return capsule.radius;
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Capsule<Scalar, Dim>& capsule) {
  const Number a = value_at<Number>(plane, capsule.a), b = value_at<Number>(plane, capsule.b);
  return a < b ? Span<Number>{a, b} : Span<Number>{b, a};
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Capsule<Scalar, Dim>& capsule) {
  return std::max(largest<Scalar, Dim>(capsule.a), largest<Scalar, Dim>(capsule.b)) + capsule.radius;
}

template <class Scalar, int Dim>
[[nodiscard]] Capsule<Scalar, Dim> moved(const Capsule<Scalar, Dim>& capsule, const Vector<Scalar, Dim>& by) {
  return {capsule.a + by, capsule.b + by, capsule.radius};
}
template <class Scalar, int Dim>
[[nodiscard]] Capsule<Scalar, Dim> turned(const Capsule<Scalar, Dim>& capsule, const Matrix<Scalar, Dim>& rotation) {
  const Vector<Scalar, Dim> middle = (capsule.a + capsule.b) / 2;
  return {middle + rotation * (capsule.a - middle), middle + rotation * (capsule.b - middle), capsule.radius};
}

}  // namespace snug
