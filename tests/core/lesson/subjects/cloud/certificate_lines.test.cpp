// The numbers of a sphere's certificate, against rational arithmetic.
#include "lesson/subjects/cloud/certificate_lines.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "core/exact.hpp"
#include "fit/catalogue.hpp"
#include "geometry/random.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"

using namespace snug;
using namespace snug::lesson;
using boost::multiprecision::cpp_int;
using exact::Rational;

namespace {

/// What a reader would make of the text.
Rational read(const ExactNumber& number) {
  std::string digits = number.whole;
  std::erase(digits, ',');
  const bool negative = digits.starts_with("−");
  Rational value(cpp_int(negative ? digits.substr(std::string_view("−").size()) : digits));
  if (negative) value = -value;
  if (number.power.empty()) return value;
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string_view left = number.power;
  constexpr std::string_view kTimesTwo = " × 2";
  REQUIRE(left.starts_with(kTimesTwo));
  left.remove_prefix(kTimesTwo.size());
  const bool below = left.starts_with("⁻");
  if (below) left.remove_prefix(std::string_view("⁻").size());
  int exponent = 0;
  while (!left.empty()) {
    const auto digit =
        std::find_if(kRaised.begin(), kRaised.end(), [&](std::string_view one) { return left.starts_with(one); });
    REQUIRE(digit != kRaised.end());
    exponent = 10 * exponent + static_cast<int>(digit - kRaised.begin());
    left.remove_prefix(digit->size());
  }
  const Rational power(cpp_int(1) << exponent);
  return below ? Rational(value / power) : Rational(value * power);
}

Rational excess_at(const Point3& point, const fit::Sphere3& sphere) {
  return exact::squared_distance<double, 3>(point, sphere.center) - Rational(sphere.radius) * Rational(sphere.radius);
}

template <class Scalar, int Dim>
AnyPointSet some_points(std::uint64_t seed, int n) {
  Random random(seed);
  std::vector<Vector<Scalar, Dim>> points(n);
  for (auto& point : points)
    for (int axis = 0; axis < Dim; ++axis) point[axis] = static_cast<Scalar>(random.between(-2, 2));
  return *PointSet<Scalar, Dim>::make(std::move(points));
}

FitRun run_of(const AnyPointSet& points, std::string_view algorithm) {
  const fit::Algorithm& own = *fit::find_algorithm("sphere", algorithm);
  return {points, own.exact, own.record(points, {.seed = 1})};
}

template <class Scalar, int Dim>
void check_lines(std::uint64_t seed, std::string_view algorithm) {
  CAPTURE(seed);
  const AnyPointSet points = some_points<Scalar, Dim>(seed, 9);
  const FitRun run = run_of(points, algorithm);
  const fit::Sphere3& sphere = *std::get_if<fit::Sphere3>(&run.recording().result.volume);
  const CertificateLines lines = *certificate_lines(run);
  REQUIRE(lines.contained.size() + static_cast<std::size_t>(lines.others) == 9);
  Rational before = excess_at(fit::point_of(points, lines.contained.front().point), sphere);
  for (const auto& line : lines.contained) {
    const Rational excess = excess_at(fit::point_of(points, line.point), sphere);
    CHECK(read(line.excess) == excess);
    CHECK(line.excess.sign == excess.sign());
    CHECK(excess <= before);
    before = excess;
  }
  Rational sum = -1;
  std::vector<Rational> mean;
  for (int axis = 0; axis < Dim; ++axis) mean.push_back(-Rational(sphere.center[axis]));
  for (const auto& own : lines.support) {
    const Point3 point = fit::point_of(points, own.point);
    CHECK((own.ulps > 0) == (excess_at(point, sphere) > 0));
    sum += Rational(*own.weight);
    for (int axis = 0; axis < Dim; ++axis) mean[axis] += Rational(*own.weight) * Rational(point[axis]);
  }
  CHECK(read(*lines.sum_off) == sum);
  for (std::size_t axis = 0; axis < mean.size(); ++axis) CHECK(read(lines.mean_off[axis]) == mean[axis]);
}

}  // namespace

TEST_CASE("the certificate's numbers are told to the last bit, of careful and of naive spheres") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const char* algorithm : {"welzl", "welzl_naive"}) {
      check_lines<float, 2>(seed, algorithm);
      check_lines<double, 2>(seed, algorithm);
      check_lines<float, 3>(seed, algorithm);
      check_lines<double, 3>(seed, algorithm);
    }
}

TEST_CASE("a whole number has no power, and its digits come in threes") {
  CHECK(exact_number(Dyadic()).text() == "0");
  CHECK(exact_number(Dyadic(-1234567)).text() == "−1,234,567");
  CHECK(exact_number(Dyadic(0x1.8p-40)).text() == "3 × 2⁻⁴¹");
}

TEST_CASE("points beyond the first few are counted, and so are those of them that are outside") {
  const AnyPointSet points = some_points<double, 2>(1, 30);
  FitRun run = run_of(points, "welzl");
  CHECK(certificate_lines(run)->others == 24);
  CHECK(certificate_lines(run)->others_outside == 0);
  fit::Recording small = run.give_up();
  small.result.volume = fit::Sphere3{Point3::Zero(), 0};
  CHECK(certificate_lines(FitRun(points, false, std::move(small)))->others_outside == 24);
}

TEST_CASE("in float the lines say how far rounding moved the points, and how far outside that leaves those given") {
  const AnyPointSet given = *PointSet<double, 2>::make({{1e8 + 3, 0}, {1e8 + 5, 0}});  // floats there are 8 apart
  const AnyPointSet rounded = *PointSet<float, 2>::make({{1e8f, 0}, {1e8f + 8, 0}});
  const auto lines = certificate_lines(run_of(rounded, "welzl"), &given);
  REQUIRE(lines->rounded.has_value());
  CHECK(lines->rounded->by == 3);
  CHECK(lines->rounded->max_outside == 0);
  CHECK(rounded_text(*lines->rounded)
            .ends_with("moved them by 3.000 units at most. Before that, they were all inside as well."));

  const AnyPointSet moved = *PointSet<float, 2>::make({{1e8f, 0}});
  const AnyPointSet near = *PointSet<double, 2>::make({{1e8 + 3, 0}});
  CHECK(rounded_text(*certificate_lines(run_of(moved, "welzl"), &near)->rounded)
            .ends_with("Before that, the farthest lay 3.000 units outside."));
  CHECK(rounded_text({}) == "All of this is about the points in float: rounding moved none of them.");
  CHECK_FALSE(certificate_lines(run_of(given, "welzl"), &given)->rounded.has_value());
}

TEST_CASE_TEMPLATE("a certified radius is the rounded distance, widened by an ulp at most", Scalar, float, double) {
  int widened = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const AnyPointSet points = some_points<Scalar, 2>(seed, 9);
    const FitRun run = run_of(points, "welzl");
    const fit::Sphere3& sphere = *std::get_if<fit::Sphere3>(&run.recording().result.volume);
    const double ulps = widened_ulps(points, sphere);
    CHECK((ulps == 0 || ulps == 1));
    CHECK(left_outside(points, sphere).none());
    (ulps > 0 ? widened : kept)++;
  }
  CHECK(widened > 5);
  CHECK(kept > 5);
}
