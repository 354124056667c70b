#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "sat.hpp"

#include <cmath>
#include <doctest/doctest.h>

using Box = snug::Obb<double, 3>;

/// A cube with edges of length 2, turned about z.
Box cube(double x, double y, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  Box box;
  box.center = {x, y, 0};
  box.axes << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  box.half_extents = {1, 1, 1};
  return box;
}

TEST_CASE("cubes that overlap") { CHECK(overlap(cube(0, 0, 0), cube(1.5, 0, 30))); }

TEST_CASE("cubes that a face of the turned one separates") { CHECK_FALSE(overlap(cube(0, 0, 0), cube(1.8, 1.8, 45))); }

TEST_CASE("cubes that touch") { CHECK(overlap(cube(0, 0, 0), cube(2, 0, 0))); }
