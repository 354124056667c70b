#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "welzl.hpp"

#include <doctest/doctest.h>

TEST_CASE("one point") { CHECK(smallest({{1, 2, 3}}).radius == doctest::Approx(0)); }

TEST_CASE("two points support it") {
  const auto sphere = smallest({{-1, 0, 0}, {1, 0, 0}, {0, 0.5, 0}});
  CHECK(sphere.radius == doctest::Approx(1));
  CHECK(sphere.center.norm() == doctest::Approx(0));
}

TEST_CASE("four points support it") {
  const auto sphere = smallest({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {0, 0, 0}});
  CHECK(sphere.radius == doctest::Approx(1.7320508075688772));
}
