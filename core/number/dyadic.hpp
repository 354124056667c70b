// Numbers that never round: integers times a power of two, closed under +, - and *. They make the decisions that must
// not be wrong, where a filter in double cannot tell.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace snug {

/// An exact value of any size: every finite double is one, and so is every sum, difference and product of them.
/// Slow (memory is allocated); filter first.
class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(double value);  // NOLINT: converts without loss. value: finite.

  /// -1, 0 or +1.
  [[nodiscard]] int sign() const noexcept {
    if (digits_.empty()) return 0;
    return negative_ ? -1 : 1;
  }
  /// The value as an odd whole number times a power of two; 0 is "0" and 0.
  struct OddTimesPower {
    std::string odd;  // its decimal digits, after "-" where it is negative
    int exponent = 0;
  };
  [[nodiscard]] OddTimesPower odd_times_power() const;
  /// The nearest double or one of its neighbours; infinite if the value is out of range.
  [[nodiscard]] double approximate() const noexcept;

  /// a / b, within 4u of its size or within the rounding of subnormal numbers; infinite if it is out of range. b: not
  /// 0. Neither a nor b need be within the range of double.
  friend double quotient(const Dyadic& a, const Dyadic& b) noexcept;

  friend Dyadic operator-(Dyadic a) {
    a.negative_ = !a.negative_;
    return a;
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.negative_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, !b.negative_); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  Dyadic& operator+=(const Dyadic& b) { return *this = *this + b; }
  Dyadic& operator-=(const Dyadic& b) { return *this = *this - b; }
  Dyadic& operator*=(const Dyadic& b) { return *this = *this * b; }
  /// -1, 0 or +1, as a is less than, equal to or greater than b.
  friend int compare(const Dyadic& a, const Dyadic& b) { return (a - b).sign(); }
  friend bool operator<(const Dyadic& a, const Dyadic& b) { return compare(a, b) < 0; }
  friend bool operator<=(const Dyadic& a, const Dyadic& b) { return compare(a, b) <= 0; }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return compare(a, b) == 0; }

 private:
  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool b_negative);
  void trim();

  /// mantissa * 2^exponent, 1 <= mantissa < 2^32, rounded from 97 bits or more; 0 for zero.
  struct Leading {
    double mantissa = 0;
    int exponent = 0;
  };
  [[nodiscard]] Leading leading() const noexcept;

  // The magnitude is the sum of digits_[i] * 2^(32 (i + place_)); no zero digit at either end.
  std::vector<std::uint32_t> digits_;
  int place_ = 0;
  bool negative_ = false;
};

}  // namespace snug
