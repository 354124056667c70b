// The lengths that stand beside a growing sphere.
#include "app/subjects/cloud/growth.hpp"

#include <doctest/doctest.h>

namespace snug::app {

TEST_CASE("dist, radius and k stand on one line, and their numbers are those of Ritter's step") {
  const fit::Sphere3 before{{1, 0, 0}, 1}, now{{2, 0, 0}, 2};  // grown to the point at x = 4
  const auto lengths = growth_lengths(before, now, {4, 0, 0});
  REQUIRE(lengths.size() == 3);
  CHECK(lengths[0].words == "dist = 3.000");
  CHECK(lengths[1].words == "radius = 1.000");
  CHECK(lengths[2].words == "k · dist = 1.000, k = 0.333");
  CHECK((lengths[1].from - lesson::Point3(0, 0, 0)).norm() == 0);
  CHECK(lengths[2].from.x() == 1);
  CHECK(lengths[2].to.x() == 2);
  CHECK(growth_lengths(before, now, before.center).empty());
}

}  // namespace snug::app
