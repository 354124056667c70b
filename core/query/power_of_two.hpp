// Units of length that cost no rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace snug::query {

/// A power of two above a length (and at most twice it), whose inverse is one too: lengths divided by it keep their digits.
/// length: >= 0, below a quarter of the largest number. Of lengths near the subnormal ones it may be more than twice.
template <class Scalar>
[[nodiscard]] Scalar power_of_two_above(Scalar length) {
  constexpr int kLeast = std::numeric_limits<Scalar>::min_exponent + 4;
  return length > 0 ? std::ldexp(Scalar(1), std::max(std::ilogb(length) + 1, kLeast)) : Scalar(1);
}

}  // namespace snug::query
