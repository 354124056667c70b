// The plane that is drawn between two volumes in space.
#include <doctest/doctest.h>

#include "app/subjects/pair/draw.hpp"
#include "geometry/random.hpp"

namespace snug::app {

TEST_CASE("the plane between two volumes lies across their axis, and is a square around the middle") {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    Point3 axis, middle;
    for (int k = 0; k < 3; ++k) axis[k] = random.between(-1, 1), middle[k] = random.between(-5, 5);
    const auto corners = plane_across(axis, middle, 2);
    for (int k = 0; k < 4; ++k) {
      CHECK(axis.dot(corners[k] - middle) == doctest::Approx(0).epsilon(1e-12));
      CHECK((corners[(k + 1) % 4] - corners[k]).norm() == doctest::Approx(4));
    }
    CHECK(((corners[0] + corners[2]) / 2 - middle).norm() < 1e-12);
  }
}

}  // namespace snug::app
