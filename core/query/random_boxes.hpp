// Generates pairs of boxes from a seed until one has a wanted property.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "query/obb_sat.hpp"
#include "query/wrong_steps.hpp"

namespace snug::query {

/// A box of about unit size around the origin, in a random orientation.
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> random_box(Random& random) {
  Quaternion turn{random.between(-1, 1), 0, 0, random.between(-1, 1)};
  if constexpr (Dim == 3) turn.x = random.between(-1, 1), turn.y = random.between(-1, 1);
  Obb<Scalar, Dim> box;
  box.axes =
      orthonormal<Scalar, Dim>(matrix_of(normalized(turn)).template topLeftCorner<Dim, Dim>().template cast<Scalar>());
  for (int axis = 0; axis < Dim; ++axis) {
    box.center[axis] = static_cast<Scalar>(random.between(-1, 1));
    box.half_extents[axis] = static_cast<Scalar>(random.between(0.05, 1));
  }
  return box;
}

/// The first pair with wanted(a, b, whether they overlap); none if no pair has it in that many tries.
template <class Scalar, int Dim, class Wanted>
[[nodiscard]] std::optional<CounterExample<Scalar, Dim>> find_boxes(std::uint64_t seed, int tries, Wanted wanted) {
  Random random(seed);
  for (int i = 0; i < tries; ++i) {
    const auto a = random_box<Scalar, Dim>(random), b = random_box<Scalar, Dim>(random);
    if (wanted(a, b, obb_sat(a, b).overlap)) return CounterExample<Scalar, Dim>{a, b, i};
  }
  return std::nullopt;
}

}  // namespace snug::query
