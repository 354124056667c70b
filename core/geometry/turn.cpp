#include "geometry/turn.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/pose.hpp"
#include "number/double_double.hpp"

namespace snug {
namespace {

constexpr double kMostReduced = 0x1p30;
constexpr double kTwoPi = 0x1.921fb54442d18p2;

// pi / 2 as an unevaluated sum of three doubles, 160 bits.
constexpr std::array<double, 3> kHalfPi{0x1.921fb54442d18p0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110};
constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;

/// radians = quarters * pi / 2 + rest, |rest| at most pi / 4 and a little.
struct Reduced {
  std::int64_t quarters;
  DoubleDouble rest;
};

Reduced reduce(double radians) {
  const double quarters = std::floor(radians * kTwoOverPi + 0.5);
  DoubleDouble rest = radians;
  for (const double piece : kHalfPi) rest -= DoubleDouble::product(quarters, piece);
  return {static_cast<std::int64_t>(quarters), rest};
}

/// The sum of coefficients[i] x^i.
template <std::size_t kTerms>
double polynomial(const std::array<double, kTerms>& coefficients, double x) {
  double sum = 0;
  for (std::size_t i = kTerms; i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

// The first term left out is below 2^-60 of the result at pi / 4.
constexpr std::array<double, 8> kSine{-1 / factorial(3),  1 / factorial(5),  -1 / factorial(7),  1 / factorial(9),
                                      -1 / factorial(11), 1 / factorial(13), -1 / factorial(15), 1 / factorial(17)};
constexpr std::array<double, 8> kCosine{1 / factorial(4),  -1 / factorial(6),  1 / factorial(8),  -1 / factorial(10),
                                        1 / factorial(12), -1 / factorial(14), 1 / factorial(16), -1 / factorial(18)};

double sine_near_zero(DoubleDouble x) {
  const double square = x.high * x.high;
  return x.high + (x.high * square * polynomial(kSine, square) + x.low * (1 - square / 2));
}

/// The cosine for small x: what 1 - x^2/2 loses in rounding is added back with the smaller terms.
double cosine_near_zero(DoubleDouble x) {
  const double square = x.high * x.high;
  const double half = square / 2;
  const double most = 1 - half;
  return most + (((1 - most) - half) + (square * square * polynomial(kCosine, square) - x.high * x.low));
}

}  // namespace

SineCosine sine_cosine(double radians) noexcept {
  if (std::abs(radians) > kMostReduced) radians = std::fmod(radians, kTwoPi);
  const Reduced reduced = reduce(radians);
  const double sine = sine_near_zero(reduced.rest);
  const double cosine = cosine_near_zero(reduced.rest);
  switch (reduced.quarters & 3) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

Matrix<double, 2> turn(double radians) noexcept {
  const auto [sine, cosine] = sine_cosine(radians);
  Matrix<double, 2> matrix;
  matrix << cosine, -sine, sine, cosine;
  return matrix;
}

Matrix<double, 3> turn(const Vector<double, 3>& axis, double radians) noexcept {
  return matrix_of(quaternion_about(axis, radians));
}

}  // namespace snug
