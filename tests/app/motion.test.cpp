// Volumes on their way from one step to the next.
#include "app/motion.hpp"

#include <doctest/doctest.h>

using namespace snug;

TEST_CASE("a sphere passes into the next one and comes to rest") {
  app::Motion motion;
  const fit::Volume3 small = fit::Sphere3{{0, 0, 0}, 1}, large = fit::Sphere3{{0, 0, 0}, 2};
  CHECK(std::get<fit::Sphere3>(*motion.at(small, false, 0)).radius == 1);
  CHECK_FALSE(motion.moving());
  CHECK(std::get<fit::Sphere3>(*motion.at(large, false, 0.01)).radius < 2);
  CHECK(motion.moving());
  CHECK(std::get<fit::Sphere3>(*motion.at(large, false, 1)).radius == 2);
  CHECK_FALSE(motion.moving());
}

TEST_CASE("a volume that passes into no other is there at once, and draws no further frames") {
  app::Motion motion;
  const fit::Volume3 box = Aabb<double, 3>{{0, 0, 0}, {1, 1, 1}}, next = Aabb<double, 3>{{0, 0, 0}, {2, 2, 2}};
  for (const fit::Volume3& volume : {box, box, next, next}) {
    CHECK(std::get<Aabb<double, 3>>(*motion.at(volume, false, 0)).max == std::get<Aabb<double, 3>>(volume).max);
    CHECK_FALSE(motion.moving());
  }
}
