// Units of length that divide without rounding.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace snug::query {

/// A power of two above a length (and at most twice it), whose inverse is a power of two as well, so that lengths
/// divided by it keep their digits. length: >= 0, below a quarter of the largest number. For lengths near the subnormal
/// numbers, it may be more than twice the length.
template <class Scalar>
[[nodiscard]] Scalar power_of_two_above(Scalar length) {
  using Bits = std::conditional_t<sizeof(Scalar) == 8, std::uint64_t, std::uint32_t>;
  constexpr int kFraction = std::numeric_limits<Scalar>::digits - 1;
  constexpr Bits kLeast =
      6;  // of exponents as they are stored: well above the subnormal numbers, which have no inverse
  const Bits exponent = __builtin_bit_cast(Bits, length) >> kFraction;
  return length > 0 ? __builtin_bit_cast(Scalar, std::max(exponent + 1, kLeast) << kFraction) : Scalar(1);
}

}  // namespace snug::query
