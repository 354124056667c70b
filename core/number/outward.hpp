// Sums rounded outwards, so that a volume still contains what it contained.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "number/two_sum.hpp"

namespace snug {

/// The least Scalar that is not below a + b; infinite if there is none. a, b: finite.
template <class Scalar>
[[nodiscard]] Scalar sum_up(Scalar a, Scalar b) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  const auto [high, low] = two_sum(a, b);
  if (high == -kInfinity) return std::numeric_limits<Scalar>::lowest();
  return low > 0 ? std::nextafter(high, kInfinity) : high;
}

/// The greatest Scalar that is not above a + b; infinite if there is none. a, b: finite.
template <class Scalar>
[[nodiscard]] Scalar sum_down(Scalar a, Scalar b) {
  return -sum_up<Scalar>(-a, -b);
}

/// The least Scalar that is not below a + b + c. Finite numbers, small enough that no sum of them overflows.
template <class Scalar>
[[nodiscard]] Scalar sum_up(Scalar a, Scalar b, Scalar c) {
  const auto [ab, ab_low] = two_sum(a, b);
  const auto [abc, abc_low] = two_sum(ab, c);
  const auto [middle, least] = two_sum(ab_low, abc_low);
  const auto [high, rest] = two_sum(abc, middle);
  const Scalar low = rest + least;  // rounded, but its sign is right
  return low > 0 ? std::nextafter(high, std::numeric_limits<Scalar>::infinity()) : high;
}

/// The greatest Scalar that is not above a + b + c. Finite numbers, small enough that no sum of them overflows.
template <class Scalar>
[[nodiscard]] Scalar sum_down(Scalar a, Scalar b, Scalar c) {
  return -sum_up<Scalar>(-a, -b, -c);
}

}  // namespace snug
