// Twice a double's digits, as an unevaluated sum of two doubles, for the few solves that decide a result.
// Source: T. J. Dekker, "A floating-point technique for extending the available precision", 1971.
// It uses no fused multiply-add, so that every bit is the same natively and in WebAssembly.
#pragma once

#include "number/two_sum.hpp"

namespace snug {

struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // NOLINT: converts without loss
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  [[nodiscard]] constexpr double value() const { return high + low; }

  /// a + b without rounding.
  static constexpr DoubleDouble sum(double a, double b) {
    const TwoSum<double> exact = two_sum(a, b);
    return {exact.high, exact.low};
  }
  /// a * b without rounding. |a|, |b| below 2^990, the product's last bit above 2^-1074.
  static constexpr DoubleDouble product(double a, double b) {
    const double p = a * b;
    const auto [a_high, a_low] = split(a);
    const auto [b_high, b_low] = split(b);
    return {p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low};
  }

  friend constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
  friend constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = sum(a.high, b.high);
    const DoubleDouble low = sum(a.low, b.low);
    const DoubleDouble part = renormal(high.high, high.low + low.high);
    return renormal(part.high, part.low + low.low);
  }
  friend constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }
  friend constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = product(a.high, b.high);
    return renormal(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  friend constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high / b.high;
    const DoubleDouble last = rest - b * DoubleDouble(second);
    return sum(first, second) + DoubleDouble(last.high / b.high);
  }
  DoubleDouble& operator+=(DoubleDouble b) { return *this = *this + b; }
  DoubleDouble& operator-=(DoubleDouble b) { return *this = *this - b; }
  DoubleDouble& operator*=(DoubleDouble b) { return *this = *this * b; }

  friend constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend constexpr bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }

 private:
  struct Halves {
    double high;
    double low;
  };
  static constexpr Halves split(double a) {
    const double c = 134217729.0 * a;  // 2^27 + 1
    const double high = c - (c - a);
    return {high, a - high};
  }
  /// |high| >= |low|, or high is 0.
  static constexpr DoubleDouble renormal(double high, double low) {
    const double s = high + low;
    return {s, low - (s - high)};
  }
};

}  // namespace snug
