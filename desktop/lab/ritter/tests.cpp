#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "ritter.hpp"

#include <doctest/doctest.h>

using Ball = snug::Sphere<double, 3>;

TEST_CASE("a point outside: the new sphere touches the back of the old one") {
  const Ball grown = grow(Ball{{0, 0, 0}, 1}, {3, 0, 0});
  CHECK(grown.radius == doctest::Approx(2));
  CHECK(grown.center[0] == doctest::Approx(1));
}

TEST_CASE("a point inside: the sphere stays as it is") {
  const Ball grown = grow(Ball{{0, 0, 0}, 2}, {1, 0, 0});
  CHECK(grown.radius == doctest::Approx(2));
  CHECK(grown.center[0] == doctest::Approx(0));
}

TEST_CASE("a sphere of radius 0") {
  const Ball grown = grow(Ball{{0, 0, 0}, 0}, {0, 2, 0});
  CHECK(grown.radius == doctest::Approx(1));
  CHECK(grown.center[1] == doctest::Approx(1));
}
