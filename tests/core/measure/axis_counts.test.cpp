// The counts over random pairs are those of the test itself, pair by pair.
#include "measure/axis_counts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "measure/random_boxes.hpp"
#include "query/overlap/obb_sat.hpp"

using namespace snug;

namespace {

template <int Dim>
void check_counts(std::uint64_t seed) {
  constexpr int kPairs = 400;
  const cost::AxisCounts counts = cost::count_axes<Dim>(kPairs, seed);
  Random random(seed);
  int overlap = 0, first_row = 0, apart_by_row = 0, faces_fail = 0;
  std::int64_t tests = 0;
  for (int i = 0; i < kPairs; ++i) {
    const auto a = cost::random_box<double, Dim>(random), b = cost::random_box<double, Dim>(random);
    const auto result = query::obb_sat(a, b);
    overlap += result.overlap ? 1 : 0;
    tests += result.tests;
    faces_fail += !result.overlap && result.tests > 2 * Dim ? 1 : 0;
    // A's first row by hand: its own x axis, with B's projected radius.
    const Vector<double, Dim> way = a.axes.col(0);
    const double radius_b = (b.axes.transpose() * way).cwiseAbs().dot(b.half_extents);
    const bool apart = std::abs(way.dot(b.center - a.center)) > a.half_extents[0] + radius_b;
    first_row += apart && !result.overlap && result.tests == 1 ? 1 : 0;
    apart_by_row += apart ? 1 : 0;
  }
  CHECK(counts.pairs == kPairs);
  CHECK(counts.overlap == overlap);
  CHECK(counts.tests == tests);
  CHECK(counts.first[0] == first_row);
  CHECK(counts.separates[0] == apart_by_row);
  CHECK(counts.edges_alone<Dim>() == faces_fail);
  CHECK(std::accumulate(counts.first.begin(), counts.first.end(), 0) + overlap == kPairs);
  for (std::size_t row = 0; row < counts.first.size(); ++row) CHECK(counts.separates[row] >= counts.first[row]);
  CHECK(overlap > kPairs / 4);  // neither answer is rare
  CHECK(overlap < 3 * kPairs / 4);
}

}  // namespace

TEST_CASE("counts over random pairs agree with each pair's own test") {
  for (const std::uint64_t seed : {1, 2, 7}) check_counts<2>(seed), check_counts<3>(seed);
  CHECK(cost::count_axes<3>(1000, 1).edges_alone<3>() > 0);
  CHECK(cost::count_axes<3>(200, 1).tests != cost::count_axes<3>(200, 2).tests);
}
