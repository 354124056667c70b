#include "number/exact_sum.hpp"

#include <doctest/doctest.h>

#include "core/at_random.hpp"
#include "core/exact.hpp"
#include "geometry/random.hpp"
#include "number/bits.hpp"
#include "number/double_double.hpp"

using snug::DoubleDouble;
using snug::ExactSum;
using snug::Random;
using snug::exact::Rational;

namespace {

int sign(const Rational& r) { return r.sign(); }

}  // namespace

TEST_CASE("an exact sum has the sign that rational arithmetic gives it") {
  Random random(1);
  int negative = 0, positive = 0;
  for (int round = 0; round < 300; ++round) {
    ExactSum sum;
    Rational expected = 0;
    for (int i = 0; i < 6; ++i) {
      const double a = snug::test::any_finite(random);
      const double b = snug::test::any_finite(random);
      sum.add_product(a, b);
      expected += Rational(a) * Rational(b);
    }
    CHECK(sum.sign() == sign(expected));
    (expected > 0 ? positive : negative) += 1;
  }
  CHECK(negative > 50);
  CHECK(positive > 50);
}

TEST_CASE("an exact sum sees what cancels and what only nearly cancels") {
  const double big = 0x1.fffffffffffffp1023;
  const double least = 0x1p-1074;
  ExactSum sum;
  CHECK(sum.sign() == 0);
  sum.add_product(big, big);
  sum.add_product(least, least);
  sum.add_product(-big, big);
  CHECK(sum.sign() == 1);
  sum.add_product(-least, least);
  CHECK(sum.sign() == 0);
  sum.add_product(least, -least);
  CHECK(sum.sign() == -1);
  ExactSum many;
  for (int i = 0; i < 100000; ++i) many.add_product(1e10, 1e10);
  for (int i = 0; i < 100000; ++i) many.add_product(-1e10, 1e10);
  CHECK(many.sign() == 0);
}

TEST_CASE("sums and products of doubles are exact as two doubles") {
  Random random(2);
  for (int round = 0; round < 2000; ++round) {
    const double a = random.between(-1, 1) * std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
    const double b = random.between(-1, 1) * std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
    const DoubleDouble product = DoubleDouble::product(a, b);
    CHECK(Rational(product.high) + Rational(product.low) == Rational(a) * Rational(b));
    const DoubleDouble sum = DoubleDouble::sum(a, b);
    CHECK(Rational(sum.high) + Rational(sum.low) == Rational(a) + Rational(b));
  }
}

TEST_CASE("a chain of double-double operations keeps about thirty digits") {
  Random random(3);
  for (int round = 0; round < 500; ++round) {
    const double a = random.between(1, 2), b = random.between(1, 2), c = random.between(1, 2);
    const DoubleDouble result = (DoubleDouble(a) * b + DoubleDouble(c)) / (DoubleDouble(a) + b) - DoubleDouble(c) / a;
    const Rational expected =
        (Rational(a) * Rational(b) + Rational(c)) / (Rational(a) + Rational(b)) - Rational(c) / Rational(a);
    const Rational error = abs(Rational(result.high) + Rational(result.low) - expected);
    CHECK(error < Rational(1) / (Rational(1ull << 50) * Rational(1ull << 48)));
  }
}
