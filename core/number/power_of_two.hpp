// Powers of two by which lengths are scaled without rounding, before they are squared or compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace snug {

/// The exponent e with 2^e <= length < 2^(e + 1), and 0 for 0: length times 2^-e is in [1, 2). It is clamped so that
/// 2^e and 2^-e are both normal numbers; a subnormal length may then stay below 1. length: >= 0.
template <class Scalar>
[[nodiscard]] int exponent_of(Scalar length) {
  constexpr int kMost = std::numeric_limits<Scalar>::max_exponent - 2;
  return length > 0 ? std::clamp(std::ilogb(length), -kMost, kMost) : 0;
}

/// 2^-e for that e.
template <class Scalar>
[[nodiscard]] Scalar to_unit_size(Scalar length) {
  return std::ldexp(Scalar(1), -exponent_of(length));
}

/// A power of two above length and at most twice it; near the subnormal numbers it may be larger. Its inverse is a
/// power of two as well, so lengths divided by it keep their digits. It calls no function, because tests that use it
/// are timed. length: >= 0, below a quarter of the largest number.
template <class Scalar>
[[nodiscard]] Scalar power_of_two_above(Scalar length) {
  using Bits = std::conditional_t<sizeof(Scalar) == 8, std::uint64_t, std::uint32_t>;
  constexpr int kFraction = std::numeric_limits<Scalar>::digits - 1;
  constexpr Bits kLeast =
      6;  // of exponents as they are stored: well above the subnormal numbers, which have no inverse
  const Bits exponent = __builtin_bit_cast(Bits, length) >> kFraction;
  return length > 0 ? __builtin_bit_cast(Scalar, std::max(exponent + 1, kLeast) << kFraction) : Scalar(1);
}

}  // namespace snug
