// A rounded sum and its rounding error, for double_double.hpp and outward.hpp.
#pragma once

namespace snug {

/// high + low is the sum without rounding; high is the rounded sum. If that is infinite, low is not a number.
template <class Scalar>
struct TwoSum {
  Scalar high;
  Scalar low;
};

/// Source: D. E. Knuth, "The Art of Computer Programming", volume 2, 1969, 4.2.2.
template <class Scalar>
[[nodiscard]] constexpr TwoSum<Scalar> two_sum(Scalar a, Scalar b) {
  const Scalar sum = a + b;
  const Scalar part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

}  // namespace snug
