// How long a lesson would take is estimated from a few of its points.
#include "lesson/patience.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "core/lesson/small_lesson.hpp"
#include "lesson/session.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::test;

namespace {

double g_now = 0;
/// Each look at the clock is as much later as the points on the stage are many, cubed.
double g_step = 0;

}  // namespace

TEST_CASE("an estimate follows the growth, and runs no more than an eighth of the points") {
  for (const double power : {1.0, 1.5, 2.0}) {
    Index most = 0;
    const auto time_of = [&](Index n) {
      most = std::max(most, n);
      return 1000 * std::pow(n, power);
    };
    const Index n = 100'000;
    const Estimate estimate = estimate_of(time_of, n);
    CHECK(most <= n / 4);
    const double whole = 1000 * std::pow(n, power);
    CHECK(estimate.whole == doctest::Approx(whole).epsilon(0.01));
    const double possible = std::pow(kLongestShown / 1000, 1 / power);
    if (whole <= kLongestShown) CHECK(estimate.most == n);
    else CHECK((estimate.most <= possible * 1.01 && estimate.most > possible / 2));
  }
}

TEST_CASE("what is certain to take too long is stopped early") {
  Index most = 0;
  const auto cubic = [&](Index n) { return most = std::max(most, n), 1.0 * n * n * n; };
  const Estimate estimate = estimate_of(cubic, 100'000);
  CHECK(most <= 1000);
  CHECK(estimate.most == 2000);
}

TEST_CASE("points that a lesson cannot show in time are refused with how many it can, and the stage stays") {
  auto lesson = read_lesson(kSmallLesson, "small.toml");
  REQUIRE(lesson.has_value());
  const Clock clock = [] { return g_now += g_step; };
  g_step = 3e9;  // each measured piece takes three seconds
  auto session = Session::open(*std::move(lesson), {}, clock);
  REQUIRE(session.has_value());
  const Index before = session->size();
  const Done done = session->set_generator("cube", 50'000, 2, 3);
  REQUIRE_FALSE(done.has_value());
  CHECK(done.error().what.find("would take about") != std::string::npos);
  CHECK(done.error().what.find("50,000 such points") != std::string::npos);
  CHECK(session->size() == before);
  g_step = 1;
  CHECK(session->set_generator("cube", 5'000, 2, 3).has_value());
  CHECK(session->size() == 5'000);
}
