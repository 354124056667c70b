// Quickhull with rounded signs, and with an epsilon: right where nothing is doubtful, wrong where it is.
#include "fit/hull/quickhull_naive.hpp"

#include <doctest/doctest.h>

#include "core/point_clouds.hpp"
#include "geometry/random.hpp"

using namespace snug;
using namespace snug::fit;

namespace {

using Points = std::vector<Vector<float, 2>>;

template <class Scalar>
std::vector<Vector<Scalar, 2>> in(const Points& points, double scale = 1) {
  std::vector<Vector<Scalar, 2>> own;
  for (const auto& point : points) own.push_back((point.cast<double>() * scale).template cast<Scalar>());
  return own;
}

/// Decimals on a line of slope 3/4, which floats round off it.
Points nearly_on_a_line(std::uint64_t seed, int n) {
  Random random(seed);
  Points points;
  for (int i = 0; i < n; ++i) {
    const double x = static_cast<double>(random.below(41)) / 10 - 2;
    points.emplace_back(static_cast<float>(x), static_cast<float>(0.75 * x));
  }
  return points;
}

}  // namespace

TEST_CASE("where no sign is doubtful, both agree with the exact one") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto points = test::set_of<double, 2>(test::generated<double, 2>("gaussian", 60, seed));
    const std::vector<Index> exact = quickhull<double, 2>(points.span()).support;
    CHECK(quickhull_naive<RoundedSides, double, 2>(points.span()).support == exact);
    CHECK(quickhull_naive<EpsilonSides, double, 2>(points.span()).support == exact);
  }
}

TEST_CASE("nearly on a line, rounded signs lead to other vertices in float, and seldom in double") {
  int wrong_in_float = 0, wrong_in_double = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Points points = nearly_on_a_line(seed, 8);
    const auto small = test::set_of<float, 2>(points);
    const auto large = test::set_of<double, 2>(in<double>(points));
    const std::vector<Index> exact = quickhull<double, 2>(large.span()).support;
    REQUIRE(quickhull<float, 2>(small.span()).support == exact);
    wrong_in_float += quickhull_naive<RoundedSides, float, 2>(small.span()).support != exact ? 1 : 0;
    wrong_in_double += quickhull_naive<RoundedSides, double, 2>(large.span()).support != exact ? 1 : 0;
  }
  CHECK(wrong_in_float > 150);
  CHECK(wrong_in_double < 30);
}

TEST_CASE("an absolute epsilon loses vertices of a small hull, and none of the same hull at unit size") {
  const auto circle = test::generated<double, 2>("sphere", 24, 7);
  const auto large = test::set_of<double, 2>(circle);
  auto shrunk = circle;
  for (auto& point : shrunk) point *= 0x1p-17;
  const auto small = test::set_of<double, 2>(shrunk);
  const auto of = [](const auto& set) { return quickhull_naive<EpsilonSides, double, 2>(set.span()).support; };
  CHECK(of(large).size() == 24);
  CHECK(of(small).size() < 20);
  CHECK(quickhull_naive<RoundedSides, double, 2>(small.span()).support.size() == 24);
}

TEST_CASE("each ends, whatever the points: a split takes a point for good") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const auto& cloud : test::degenerate_clouds<float, 2>(seed, 40)) {
      CAPTURE(cloud.name);
      const auto points = test::set_of<float, 2>(cloud.points);
      CHECK(quickhull_naive<RoundedSides, float, 2>(points.span()).support.size() <= cloud.points.size());
      CHECK(quickhull_naive<EpsilonSides, float, 2>(points.span()).support.size() <= cloud.points.size());
    }
}
