// Welzl's recursion as it is printed, beside the loop.
#include <doctest/doctest.h>

#include "core/fit/promises.hpp"
#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"

using namespace snug;

namespace {

const fit::Algorithm& sphere(const char* name) { return *fit::find_algorithm("sphere", name); }

}  // namespace

TEST_CASE("Welzl as printed ends with the ball of the loop, and tests each point against the ball that it was given") {
  for (const char* kind : {"gaussian", "cube", "sphere", "lattice", "clusters", "line"})
    for (const int n : {1, 2, 5, 40, 300})
      for (const std::uint64_t seed : {1, 2}) {
        CAPTURE(kind);
        CAPTURE(n);
        const auto points = test::set_of<double, 3>(test::generated<double, 3>(kind, n, seed));
        const fit::Recording run = sphere("welzl_recursive").record(points, {.seed = seed});
        const double radius = ball_of(sphere("welzl").fit(points, {.seed = seed})).radius;
        CHECK(std::abs(ball_of(run.result).radius - radius) <= 1e-14 * radius);
        for (const auto& entry : run.steps) {
          const auto* decided = std::get_if<fit::CallDecided>(&entry.step.fact);
          if (decided == nullptr || !entry.step.has_volume) continue;
          const double gap = decided->distance - ball_of(entry.step)->radius;
          if (std::abs(gap) > 1e-9 * decided->distance) CHECK(decided->outside == (gap > 0));
        }
      }
}
