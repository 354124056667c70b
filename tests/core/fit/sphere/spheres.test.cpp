// What sphere fitters promise beyond what all fitters do (promises.test.cpp).
#include <doctest/doctest.h>

#include <algorithm>

#include "core/fit/promises.hpp"
#include "fit/catalogue.hpp"
#include "fit/obb/principal_axes.hpp"

using namespace snug;
using fit::Algorithm;

TEST_CASE_TEMPLATE("a covariance holds as many points as there are, as far out as they may lie", Scalar, float,
                   double) {
  constexpr Scalar kFar = PointSet<Scalar, 2>::kLargest;
  test::Cloud<Scalar, 2> points;
  for (int i = 0; i < 1000; ++i) points.push_back({i % 2 == 0 ? kFar : -kFar, i % 2 == 0 ? kFar : -kFar});
  const auto set = *PointSet<Scalar, 2>::make(points);
  Ignore ignore;
  const auto mean = fit::mean_of(set.span(), ignore);
  const auto found = fit::covariance_of(mean.mean, set.span(), ignore);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) CHECK(found.covariance(row, column) == kFar * kFar);
  test::check_promises<Scalar, 2>(fit::algorithms_of("sphere"), "far out", points);
}

TEST_CASE("traces have equal hashes for equal seeds, and others for others") {
  const AnyPointSet set = test::set_of<double, 2>(test::generated<double, 2>("gaussian", 50, 3));
  for (const Algorithm& algorithm : fit::algorithms_of("sphere")) {
    if (fit::count_of(set) > algorithm.max_points) continue;
    const auto hash = [&](std::uint64_t seed) { return fit::hash_of(algorithm.record(set, {seed}).steps); };
    CHECK(hash(1) == hash(1));
    const bool random = algorithm.name == "ritter_iterative" || algorithm.name == "welzl" ||
                        algorithm.name == "pivot" || algorithm.name == "welzl_recursive" || algorithm.naive;
    CHECK((hash(1) != hash(2)) == random);
  }
}

TEST_CASE("the point that the last check finds farthest is among those that a grown sphere touches") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    for (const char* name : {"ritter", "ritter_iterative", "pca"}) {
      const AnyPointSet set = test::set_of<double, 2>(test::generated<double, 2>("gaussian", 9, seed));
      const auto run = fit::find_algorithm("sphere", name)->record(set, {seed});
      const auto& support = run.result.support;
      for (const auto& entry : run.steps)
        if (const auto* checked = std::get_if<fit::RadiusChecked>(&entry.step.fact))
          CHECK(std::find(support.begin(), support.end(), checked->farthest) != support.end());
      CHECK(run.certificate.on_boundary);
    }
}

TEST_CASE("counts grow along a trace and end at the whole run's") {
  const AnyPointSet set = test::set_of<double, 3>(test::generated<double, 3>("cube", 200, 3));
  for (const Algorithm& algorithm : fit::algorithms_of("sphere")) {
    if (fit::count_of(set) > algorithm.max_points) continue;
    const auto run = algorithm.record(set, {});
    OperationCounts before{};
    for (const auto& entry : run.steps) {
      for (std::size_t i = 0; i < before.size(); ++i) REQUIRE(entry.counts[i] >= before[i]);
      before = entry.counts;
    }
    CHECK(before == run.counts);
    CHECK(run.counts[static_cast<std::size_t>(Operation::kPointsTouched)] >= 200);
  }
}
