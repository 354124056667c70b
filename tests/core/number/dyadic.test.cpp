#include "number/dyadic.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/exact.hpp"
#include "geometry/random.hpp"
#include "number/bits.hpp"

using snug::Dyadic;
using snug::Random;
using snug::exact::Rational;

namespace {

/// Any finite double, or one of the few that are special.
double any_double(Random& random) {
  constexpr std::array kSpecial{0.0, -0.0, 1.0, -1.0, 0x1p-1074, 0x1p1023, 0x1.fffffffffffffp1023, 0x1p32, -0x1p-32};
  if (random.below(4) == 0) return kSpecial[random.below(kSpecial.size())];
  for (;;) {
    const double value = snug::double_of(random.bits());
    if (std::isfinite(value)) return value;
  }
}

/// A few operations on a few doubles, the same in both arithmetics.
template <class Number>
Number mixed(const std::array<double, 5>& x) {
  const Number a(x[0]), b(x[1]), c(x[2]), d(x[3]), e(x[4]);
  return (a * b - c * d) * (a + e) - (b - c) * (d * e) * a;
}

}  // namespace

TEST_CASE("a dyadic number has the sign and size that rational arithmetic gives it") {
  Random random(1);
  int negative = 0, positive = 0, zero = 0;
  for (int round = 0; round < 400; ++round) {
    std::array<double, 5> x{};
    for (double& value : x) value = any_double(random);
    const Dyadic mine = mixed<Dyadic>(x);
    const Rational right = mixed<Rational>(x);
    REQUIRE(mine.sign() == right.sign());
    (right.sign() < 0 ? negative : right.sign() > 0 ? positive : zero)++;
    const auto nearest = right.convert_to<double>();
    if (std::isfinite(nearest) && std::abs(nearest) > 0x1p-1000)
      CHECK(std::abs(mine.approximate() / nearest - 1) < 0x1p-51);
  }
  CHECK(negative > 50);
  CHECK(positive > 50);
  CHECK(zero > 2);
}

TEST_CASE("a quotient is as near as a double can be, wherever its parts lie") {
  for (const double power : {1.0, 0x1p-1074, 0x1p1000}) {
    const Dyadic three = Dyadic(3) * Dyadic(power) * Dyadic(power), seven = Dyadic(7) * Dyadic(power) * Dyadic(power);
    CHECK(std::abs(quotient(three, seven) * 7 / 3 - 1) < 0x1p-50);
    CHECK(quotient(-three, seven) == -quotient(three, seven));
    CHECK(quotient(Dyadic(), seven) == 0);
  }
  CHECK(std::isinf(quotient(Dyadic(0x1p1000), Dyadic(0x1p-1000))));
  CHECK(quotient(Dyadic(0x1p-1074), Dyadic(3)) == 0);
}

TEST_CASE("what cancels to nothing is nothing, and comparisons tell the last bit") {
  for (const double value : {1.0, -3.5, 0x1p-1074, 0x1.fffffffffffffp1023}) {
    CHECK((Dyadic(value) - Dyadic(value)).sign() == 0);
    CHECK(Dyadic(value) == Dyadic(value));
    CHECK(Dyadic(std::nextafter(value, -std::numeric_limits<double>::infinity())) < Dyadic(value));
  }
  CHECK(compare(Dyadic(0x1p1000) + Dyadic(0x1p-1000), Dyadic(0x1p1000)) == 1);
  CHECK((Dyadic(0x1p64) - Dyadic(0x1p64) - Dyadic(1)).sign() == -1);
}

TEST_CASE("a dyadic number is told as an odd whole number times a power of two, whatever its size") {
  const auto told = [](const Dyadic& value) { return value.odd_times_power(); };
  CHECK(told(Dyadic()).odd == "0");
  CHECK(told(Dyadic(0.75)).odd == "3");
  CHECK(told(Dyadic(0.75)).exponent == -2);
  CHECK(told(Dyadic(-6)).odd == "-3");
  CHECK(told(Dyadic(0x1p64) + Dyadic(1)).odd == "18446744073709551617");
  CHECK(told(Dyadic(1e9) * Dyadic(1e9) + Dyadic(1)).odd == "1000000000000000001");
  Random random(2);
  for (int round = 0; round < 100; ++round) {
    std::array<double, 5> x{};
    for (double& value : x) value = random.between(-1, 1) * std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
    const auto [odd, exponent] = told(mixed<Dyadic>(x));
    const boost::multiprecision::cpp_int whole(odd), power = boost::multiprecision::cpp_int(1) << std::abs(exponent);
    CHECK(whole % 2 != 0);
    CHECK((exponent < 0 ? Rational(whole, power) : Rational(whole * power)) == mixed<Rational>(x));
  }
}
