// Boxes from a seed.
#pragma once

#include "geometry/obb.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"

namespace snug::cost {

/// A box of about unit size around the origin, in a random orientation.
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> random_box(Random& random) {
  Quaternion turn{random.between(-1, 1), 0, 0, random.between(-1, 1)};
  if constexpr (Dim == 3) {
    turn.x = random.between(-1, 1);
    turn.y = random.between(-1, 1);
  }
  Obb<Scalar, Dim> box;
  box.axes =
      orthonormal<Scalar, Dim>(matrix_of(normalized(turn)).template topLeftCorner<Dim, Dim>().template cast<Scalar>());
  for (int axis = 0; axis < Dim; ++axis) {
    box.center[axis] = static_cast<Scalar>(random.between(-1, 1));
    box.half_extents[axis] = static_cast<Scalar>(random.between(0.05, 1));
  }
  return box;
}

}  // namespace snug::cost
