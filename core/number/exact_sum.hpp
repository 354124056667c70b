// Sums of products of doubles without any rounding, for decisions that must not be wrong.
#pragma once

#include <array>
#include <cstdint>

namespace snug {

/// A fixed-point accumulator wide enough for every product of two finite doubles, so that sums of them are exact
/// over the whole range of exponents, subnormals included.
/// Source: U. Kulisch, "Advanced Arithmetic for the Digital Computer", 2002.
class ExactSum {
 public:
  /// Adds a * b exactly. a, b: finite. At most 2^30 calls.
  void add_product(double a, double b) noexcept;

  /// -1, 0 or +1: the sign of the exact sum.
  [[nodiscard]] int sign() const noexcept;

 private:
  void add_shifted(std::uint64_t value, int position, bool negative) noexcept;

  // Bit 0 weighs 2^-2148, the square of the smallest subnormal; digits hold 32 bits and 31 for carries to come.
  static constexpr int kLowestExponent = -2148;
  static constexpr int kDigits = (2148 + 2048 + 96) / 32;
  std::array<std::int64_t, kDigits> digits_{};
};

}  // namespace snug
