// Brute force over the largest subsets alone, as lectures print it, beside brute force over all.
#include <doctest/doctest.h>

#include "core/fit/promises.hpp"
#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"

using namespace snug;

namespace {

const fit::Algorithm& sphere(const char* name) { return *fit::find_algorithm("sphere", name); }

}  // namespace

TEST_CASE("of the largest subsets alone the ball is too large where fewer points support the smallest") {
  // Two points far apart and one near their line: the circle through all three is far larger than that of the two.
  const auto flat = test::set_of<double, 2>({{-2, 0}, {2, 0}, {0, 0.5}});
  CHECK(ball_of(sphere("brute_force").fit(flat, {})).radius == 2);
  const fit::Recording printed = sphere("brute_force_slide").record(flat, {});
  CHECK(ball_of(printed.result).radius == doctest::Approx(4.25));
  CHECK(printed.certificate.contains);
  CHECK_FALSE(printed.certificate.optimal);
  // Where as many support it, both are the same.
  const auto full = test::set_of<double, 3>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0, 0.2, 0.1}});
  CHECK(ball_of(sphere("brute_force_slide").fit(full, {})).radius ==
        ball_of(sphere("brute_force").fit(full, {})).radius);
}

TEST_CASE_TEMPLATE("the largest subsets alone are never better than all, and contain all points", Scalar, float,
                   double) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const auto& named : test::degenerate_clouds<Scalar, 2>(seed, 8)) {
      CAPTURE(named.name);
      const auto points = test::set_of<Scalar, 2>(named.points);
      const auto printed = sphere("brute_force_slide").watch(points, {}, {});
      CHECK(printed.certificate.contains);
      CHECK(std::isfinite(ball_of(printed.result).radius));
    }
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const char* kind : {"gaussian", "cube", "stick"}) {
      const auto points = test::set_of<Scalar, 3>(test::generated<Scalar, 3>(kind, 8, seed));
      const double all = ball_of(sphere("brute_force").fit(points, {})).radius;
      CHECK(ball_of(sphere("brute_force_slide").fit(points, {})).radius >= all * (1 - 1e-6));
    }
}

TEST_CASE("where the largest subsets have no ball, fewer points do") {
  const auto line = test::set_of<double, 2>({{0, 0}, {1, 1}, {3, 3}, {2, 2}});
  const fit::Recording run = sphere("brute_force_slide").record(line, {});
  CHECK(ball_of(run.result).radius == doctest::Approx(std::sqrt(4.5)));
  CHECK(run.result.support.size() == 2);
  int dependent = 0;
  for (const auto& entry : run.steps)
    if (const auto* tried = std::get_if<fit::CandidateTried<double, 3>>(&entry.step.fact))
      if (tried->verdict == fit::CandidateTried<double, 3>::Verdict::kDependent) ++dependent;
  CHECK(dependent == 4);
  const auto plane = test::set_of<double, 3>({{-1, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, -1, 2}, {0.2, 0.1, 2}});
  CHECK(ball_of(sphere("brute_force_slide").fit(plane, {})).radius == 1);
  const auto one = test::set_of<double, 3>({{1, 2, 3}, {1, 2, 3}});
  CHECK(ball_of(sphere("brute_force_slide").fit(one, {})).radius == 0);
}
