// Numbers and directions at random that tests share.
#pragma once

#include <cmath>

#include "geometry/random.hpp"
#include "geometry/vector.hpp"
#include "number/bits.hpp"

namespace snug::test {

/// Any finite double, every pattern of bits alike.
inline double any_finite(Random& random) {
  for (;;) {
    const double value = double_of(random.bits());
    if (std::isfinite(value)) return value;
  }
}

/// Not of unit length.
inline Vector<double, 3> any_direction(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

}  // namespace snug::test
