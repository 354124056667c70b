// The cylinder. It is not a bounding volume here, because its flat ends make it expensive to test. It stands beside the
// capsule on the same axis, to be compared with it.
#pragma once

#include "geometry/core.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// All p no farther than radius from the line through a and b, and between the planes perpendicular to it at a and at
/// b, which are different points. In 2-D a rectangle.
template <class Scalar, int Dim>
struct Cylinder {
  Vector<Scalar, Dim> a = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> b = Vector<Scalar, Dim>::UnitX();
  Scalar radius = 0;  // >= 0
  SNUG_FIELDS(a, b, radius);
};

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Cylinder<Scalar, Dim>& cylinder) {
  return cylinder.a;
}

/// A point of a rim. The direction is projected across the axis twice: if it is nearly along the axis, one projection
/// leaves mostly rounding error.
template <class Scalar, int Dim>
[[nodiscard]] Vector<double, Dim> core_support(const Cylinder<Scalar, Dim>& cylinder, const Vector<Scalar, Dim>& origin,
                                               const Vector<double, Dim>& direction) {
  const Vector<double, Dim> axis = difference(cylinder.b, cylinder.a).normalized();
  const double along = direction.dot(axis);
  const Vector<double, Dim> end = difference(along > 0 ? cylinder.b : cylinder.a, origin);
  Vector<double, Dim> across = direction - axis * along;
  const double length = across.norm();
  if (!(length > 0)) return end;
  across /= length;
  across -= axis * across.dot(axis);
  return end + static_cast<double>(cylinder.radius) * across;
}

}  // namespace snug
