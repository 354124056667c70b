// The points at which two bodies touch, and how far the way to a contact is.
#include "physics/manifold.hpp"

#include <cmath>
#include <doctest/doctest.h>

#include "physics/sweep.hpp"

namespace snug::physics {

namespace {

Shape box(const V3& half) { return {.kind = Shape::Kind::kBox, .half_extents = half, .thinnest = half.minCoeff()}; }
Shape ball(double radius) { return {.kind = Shape::Kind::kSphere, .radius = radius, .thinnest = radius}; }
Pose<double, 3> at(double x, double y, double z) { return {Matrix<double, 3>::Identity(), V3(x, y, z)}; }

}  // namespace

TEST_CASE("a box on a larger one has the four vertices of its face as contact points") {
  const Manifold manifold = manifold_of(box(V3(5, 1, 5)), at(0, 0, 0), box(V3(1, 1, 1)), at(0, 1.99, 0), 0.1);
  REQUIRE(manifold.count == 4);
  CHECK(manifold.normal == V3(0, 1, 0));
  for (const ManifoldPoint& point : manifold.all()) {
    CHECK(point.separation == doctest::Approx(-0.01));
    CHECK(std::abs(point.position[0]) == 1);
    CHECK(std::abs(point.position[2]) == 1);
  }
}

TEST_CASE("the normal points from the first body to the second, whichever is the box") {
  const Shape cube = box(V3(1, 1, 1)), small = ball(0.5);
  const Manifold from_box = manifold_of(cube, at(0, 0, 0), small, at(1.5, 0, 0), 0.1);
  const Manifold from_ball = manifold_of(small, at(1.5, 0, 0), cube, at(0, 0, 0), 0.1);
  REQUIRE(from_box.count == 1);
  REQUIRE(from_ball.count == 1);
  CHECK(from_box.normal == V3(1, 0, 0));
  CHECK(from_ball.normal == V3(-1, 0, 0));
  CHECK(from_box.points[0].position == from_ball.points[0].position);
  CHECK(from_box.points[0].separation == 0);
}

TEST_CASE("bodies farther apart than the margin have no contact") {
  CHECK(manifold_of(ball(1), at(0, 0, 0), ball(1), at(2.2, 0, 0), 0.1).count == 0);
  CHECK(manifold_of(ball(1), at(0, 0, 0), ball(1), at(2.05, 0, 0), 0.1).count == 1);
  CHECK(separation_of(ball(1), at(0, 0, 0), ball(1), at(2.5, 0, 0)) == doctest::Approx(0.5));
}

TEST_CASE("conservative advancement stops a ball at a thin wall, at any speed") {
  const Shape wall = box(V3(0.01, 10, 10)), small = ball(0.1);
  for (const double way : {3.0, 30.0, 300.0}) {
    CAPTURE(way);
    const auto separation = [&](double part) {
      return separation_of(small, at(-2 + way * part, 0, 0), wall, at(0, 0, 0));
    };
    const double part = part_above(0, separation(0), separation, way, 0.1 / 4, 1);
    CHECK(way * part == doctest::Approx(2 - 0.11).epsilon(1e-4));
  }
}

TEST_CASE("a way that meets nothing is free to its end") {
  const auto separation = [](double) { return 1.0; };
  CHECK(part_above(0, 1, separation, 5, 0.1, 1) == 1);
}

}  // namespace snug::physics
