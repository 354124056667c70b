// Tiny points have the spheres of the same points at scale 1.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "geometry/convert.hpp"

using namespace snug;

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
