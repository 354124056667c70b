// Sine, cosine and rotations of our own, against fifty decimal digits and rational arithmetic.
#include "geometry/turn.hpp"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/exact.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/tolerance.hpp"

using namespace snug;
using exact::Rational;
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<80>>;

namespace {

/// How many units in the last place value is from right.
double ulps(double value, const Digits& right) {
  const auto nearest = std::abs(right.convert_to<double>());
  const double ulp = std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
  return std::abs(((Digits(value) - right) / Digits(ulp)).convert_to<double>());
}

/// The worst of sine and cosine, in units in the last place.
double worst_at(double radians) {
  const auto [sine, cosine] = sine_cosine(radians);
  const Digits x(radians);
  return std::max(ulps(sine, sin(x)), ulps(cosine, cos(x)));
}

Vector<double, 3> any_axis(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

/// The square of the Frobenius norm of m^T m - 1, exactly: 0 for a rotation.
template <class Scalar, int Dim>
Rational from_orthogonal(const Matrix<Scalar, Dim>& m) {
  Rational sum = 0;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      const auto at = [&](int row, int column) { return Rational(static_cast<double>(m(row, column))); };
      Rational entry = i == j ? -1 : 0;
      for (int k = 0; k < Dim; ++k) entry += at(k, i) * at(k, j);
      sum += entry * entry;
    }
  return sum;
}

}  // namespace

TEST_CASE("no turn is exactly none, and a quarter turn is one within rounding") {
  CHECK(turn(0) == Matrix<double, 2>::Identity());
  CHECK(turn({0, 0, 1}, 0) == Matrix<double, 3>::Identity());
  CHECK(turn({0, 0, 0}, 1) == Matrix<double, 3>::Identity());
  const auto [sine, cosine] = sine_cosine(std::numbers::pi / 2);
  CHECK(sine == 1);
  CHECK(cosine == 0x1.1a62633145c07p-54);  // the double nearest to pi / 2 is that much short of it
  CHECK(sine_cosine(0x1p-1074).sine == 0x1p-1074);
}

TEST_CASE("sine and cosine are within one unit in the last place") {
  Random random(1);
  double worst = 0;
  for (int round = 0; round < 1500; ++round) worst = std::max(worst, worst_at(random.between(-7, 7)));
  for (int quarter = -8; quarter <= 8; ++quarter)  // where one of them is nearly 0
    for (int step = -2; step <= 2; ++step) {
      double x = quarter * (std::numbers::pi / 2);
      for (int k = 0; k < std::abs(step); ++k) x = std::nextafter(x, step * 1e9);
      worst = std::max(worst, worst_at(x));
    }
  for (int exponent = -1022; exponent <= 30; ++exponent)
    worst = std::max(worst, worst_at(std::ldexp(0.7 + random.unit() * 0.3, exponent)));
  CHECK(worst < 1);
  CHECK(worst > 0.5);  // the measure is not idle
}

TEST_CASE("a very large angle still makes a rotation") {
  for (const double radians : {0x1p31, 1e15, -1e100, 0x1.fffffffffffffp1023}) {
    const auto [sine, cosine] = sine_cosine(radians);
    CHECK(sine * sine + cosine * cosine == doctest::Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("a turn about an axis has the entries of Rodrigues' formula") {
  Random random(2);
  for (int round = 0; round < 300; ++round) {
    const double scale = round % 3 == 0 ? 1e-160 : round % 3 == 1 ? 1 : 1e150;
    const Vector<double, 3> axis = scale * any_axis(random);
    const double radians = random.between(-7, 7);
    const Matrix<double, 3> found = turn(axis, radians);
    std::array<Digits, 3> unit{Digits(axis[0]), Digits(axis[1]), Digits(axis[2])};
    const Digits norm = sqrt(unit[0] * unit[0] + unit[1] * unit[1] + unit[2] * unit[2]);
    for (Digits& coordinate : unit) coordinate /= norm;
    const Digits sine = sin(Digits(radians)), cosine = cos(Digits(radians));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        Digits right = (1 - cosine) * unit[i] * unit[j] + (i == j ? cosine : Digits(0));
        if (i != j) right += ((j + 3 - i) % 3 == 1 ? -1 : 1) * sine * unit[3 - i - j];
        const Digits error = abs(Digits(found(static_cast<int>(i), static_cast<int>(j))) - right);
        CHECK(error.convert_to<double>() < 8 * tolerance::kRoundoff<double>);
      }
  }
}

TEST_CASE("a rotation matrix, and the same rounded to float, lengthens nothing by more than its tolerance says") {
  Random random(3);
  Rational worst = 0, worst_float = 0;
  for (int round = 0; round < 400; ++round) {
    const Matrix<double, 3> space = turn(any_axis(random), random.between(-4, 4));
    const Matrix<double, 2> plane = turn(random.between(-4, 4));
    worst = std::max({worst, from_orthogonal<double, 3>(space), from_orthogonal<double, 2>(plane)});
    const Matrix<float, 3> space_float = space.cast<float>();
    const Matrix<float, 2> plane_float = plane.cast<float>();
    worst_float =
        std::max({worst_float, from_orthogonal<float, 3>(space_float), from_orthogonal<float, 2>(plane_float)});
  }
  // |m^T m - 1| <= 2e keeps every singular value of m within e of 1.
  const Rational bound = 2 * Rational(tolerance::kRotation<double>);
  const Rational bound_float = 2 * Rational(static_cast<double>(tolerance::kRotation<float>));
  CHECK(worst < bound * bound);
  CHECK(worst > bound * bound / 1024);
  CHECK(worst_float < bound_float * bound_float);
  CHECK(worst_float > bound_float * bound_float / 1024);
}

TEST_CASE("quaternions compose as their matrices do, and drift is taken back") {
  Random random(4);
  Quaternion many;
  Matrix<double, 3> matrix = Matrix<double, 3>::Identity();
  for (int round = 0; round < 2000; ++round) {
    const Quaternion q = quaternion_about(any_axis(random), random.between(-1, 1));
    many = normalized(q * many);
    matrix = orthonormal<double, 3>(matrix_of(q) * matrix);
  }
  CHECK((matrix_of(many) - matrix).cwiseAbs().maxCoeff() < 1e-12);
  const double bound = 2 * tolerance::kRotation<double>;
  CHECK(from_orthogonal<double, 3>(matrix) < Rational(bound) * Rational(bound));
  CHECK(from_orthogonal<double, 3>(matrix_of(many)) < Rational(bound) * Rational(bound));
}

TEST_CASE("a quaternion of any size is made unit, and none turns nothing") {
  for (const double scale : {1e-320, 1e-160, 1.0, 1e308}) {
    const Quaternion q = normalized({scale, -scale, scale, scale});
    CHECK(q.w == 0.5);
    CHECK(q.x == -0.5);
  }
  CHECK(normalized({0, 0, 0, 0}).w == 1);
}

TEST_CASE("a pose turns about the local origin and then moves") {
  const Pose<double, 2> pose{turn(std::numbers::pi / 2), {10, 0}};
  const Vector<double, 2> p = placed<double, 2>(pose, {1, 0});
  CHECK((p - Vector<double, 2>(10, 1)).cwiseAbs().maxCoeff() < 1e-15);
}
