// What sphere fitters promise beyond what all fitters do (promises.test.cpp).
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "core/fit/promises.hpp"
#include "fit/catalogue.hpp"
#include "fit/obb/principal_axes.hpp"
#include "geometry/convert.hpp"

using namespace snug;
using fit::Algorithm;

TEST_CASE_TEMPLATE("subnormal points have a smallest ball too", Scalar, float, double) {
  constexpr Scalar kStep = std::numeric_limits<Scalar>::denorm_min();
  Random random(2);
  for (int turn = 0; turn < 50; ++turn) {
    test::Cloud<Scalar, 3> points(4);
    for (auto& p : points)
      for (int axis = 0; axis < 3; ++axis) p[axis] = kStep * static_cast<Scalar>(random.below(20));
    const auto run = fit::find_algorithm("sphere", "brute_force")->record(test::set_of<Scalar, 3>(points), {});
    CHECK(run.result.support.size() >= 1);
    CHECK(run.certificate.contains);
    CHECK(run.certificate.on_boundary);
    CHECK(run.certificate.optimal == true);
  }
}

TEST_CASE_TEMPLATE("points of any scale have the sphere of the same points at scale 1", Scalar, float, double) {
  constexpr int kLeast = std::numeric_limits<Scalar>::min_exponent - 1;  // of normal numbers
  const Scalar step = std::numeric_limits<Scalar>::denorm_min();
  for (const fit::Algorithm& algorithm : fit::algorithms_of("sphere")) {
    if (algorithm.naive) continue;
    CAPTURE(algorithm.name);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      CAPTURE(seed);
      const auto points = test::generated<Scalar, 3>(seed % 3 == 0 ? "clusters" : "gaussian", 12, seed);
      const auto at_one = algorithm.record(test::set_of<Scalar, 3>(points), {});
      for (const int exponent : {kLeast / 3, kLeast / 2, 2 * kLeast / 3, kLeast + 40, kLeast + 4, kLeast - 12}) {
        CAPTURE(exponent);
        auto tiny = points;
        for (auto& p : tiny)
          for (int i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], exponent);
        const auto run = algorithm.record(test::set_of<Scalar, 3>(tiny), {});
        const auto ball = converted<Scalar, 3>(fit::ball_of(run.result));
        const auto like = converted<Scalar, 3>(fit::ball_of(at_one.result));
        CHECK(run.certificate.contains);
        CHECK(run.certificate.optimal == at_one.certificate.optimal);
        const Scalar radius = std::ldexp(like.radius, exponent);
        if (exponent > kLeast + 30) {  // nothing is rounded
          CHECK(run.result.support == at_one.result.support);
          CHECK(run.steps.size() == at_one.steps.size());
          CHECK(ball.radius == radius);
          for (int i = 0; i < 3; ++i) CHECK(ball.center[i] == std::ldexp(like.center[i], exponent));
        } else {
          CHECK(std::abs(ball.radius - radius) <= 4 * step + radius / 1000);
        }
      }
    }
  }
}

TEST_CASE("three points that are 1e-170 apart have their circle, and the steps are told in their units") {
  const AnyPointSet points = test::set_of<double, 3>({{0, 0, 0}, {4e-170, 0, 0}, {1e-170, 2e-170, 0}});
  for (const char* const name : {"welzl", "pivot", "welzl_recursive", "brute_force"}) {
    CAPTURE(name);
    double farthest = 0;
    const auto see = [&](fit::Step3&& step, const OperationCounts&) {
      if (const auto* found = std::get_if<fit::PointExamined>(&step.fact))
        farthest = std::max(farthest, found->distance);
      if (const fit::Sphere3* ball = fit::ball_of(step)) CHECK(ball->radius < 5e-170);
    };
    const auto run = fit::find_algorithm("sphere", name)->watch(points, {}, see);
    CHECK(fit::ball_of(run.result).radius / 2.0155644370746374e-170 == doctest::Approx(1).epsilon(1e-12));
    CHECK(run.certificate.optimal == true);
    CHECK(farthest < 1e-169);
  }
}

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

TEST_CASE("the order of its points changes the smallest ball by no more than rounding") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    auto points = test::generated<double, 3>("gaussian", 60, seed);
    const Algorithm& welzl = *fit::find_algorithm("sphere", "welzl");
    const double radius = ball_of(welzl.fit(test::set_of<double, 3>(points), {})).radius;
    Random random(seed);
    for (std::size_t i = points.size() - 1; i > 0; --i)
      std::swap(points[i], points[random.below(static_cast<std::uint32_t>(i + 1))]);
    CHECK(ball_of(welzl.fit(test::set_of<double, 3>(points), {})).radius == doctest::Approx(radius).epsilon(1e-15));
  }
}

TEST_CASE("Welzl holds no more points on the boundary than Dim + 1, however many there are") {
  for (const int n : {10, 100, 1000, 20000}) {
    const auto run = fit::find_algorithm("sphere", "welzl")
                         ->record(test::set_of<double, 3>(test::generated<double, 3>("ball", n, 2)), {});
    int deepest = 0;
    for (const auto& entry : run.steps)
      if (const auto* forced = std::get_if<fit::BoundaryForced>(&entry.step.fact))
        deepest = std::max(deepest, forced->depth);
    CHECK(deepest >= 2);
    CHECK(deepest <= 4);
  }
}

TEST_CASE("Welzl touches each of a hundred thousand points a few times; pivoting passes over them a few times") {
  constexpr int kMany = 100'000;
  const auto touched = [](const char* algorithm, const AnyPointSet& set) {
    const auto run = fit::find_algorithm("sphere", algorithm)->watch(set, {}, {});
    CHECK(run.certificate.optimal == true);
    return run.counts[static_cast<std::size_t>(Operation::kPointsTouched)];
  };
  for (const char* kind : {"gaussian", "sphere", "cube"}) {
    const AnyPointSet set = test::set_of<double, 3>(test::generated<double, 3>(kind, kMany, 3));
    CHECK(touched("welzl", set) < 40 * kMany);
    CHECK(touched("pivot", set) < 20 * kMany);
  }
}

TEST_CASE("traces have equal hashes for equal seeds, and others for others") {
  const AnyPointSet set = test::set_of<double, 2>(test::generated<double, 2>("gaussian", 50, 3));
  for (const Algorithm& algorithm : fit::algorithms_of("sphere")) {
    if (fit::size_of(set) > algorithm.max_points) continue;
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
    if (fit::size_of(set) > algorithm.max_points) continue;
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
