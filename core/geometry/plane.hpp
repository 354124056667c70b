// The plane (in 2-D the line) as the boundary of a half-space.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

/// The half-space of all p with normal . p + d <= 0: the normal points out of it. It need not be unit.
template <class Scalar, int Dim>
struct Plane {
  Vector<Scalar, Dim> normal = Vector<Scalar, Dim>::Zero();
  Scalar d = 0;
};

/// normal . p + d, rounded in double: negative inside, and the distance if the normal is unit.
template <class Scalar, int Dim>
[[nodiscard]] double signed_distance(const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& p) {
  return plane.normal.template cast<double>().dot(p.template cast<double>()) + static_cast<double>(plane.d);
}

}  // namespace snug
