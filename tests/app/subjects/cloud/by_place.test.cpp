// Points that share a place are named once.
#include "app/subjects/cloud/by_place.hpp"

#include <doctest/doctest.h>

namespace snug::app {

TEST_CASE("points in the same place share one name, which is the worst one's where it is among them") {
  const std::vector<Vector<double, 3>> places{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const auto placed = by_place({0, 1, 2, 3, 4, 5}, 3, [&](Index i) { return places[i]; });
  REQUIRE(placed.size() == 3);
  CHECK(placed[0].first == 0);
  CHECK(placed[0].more == 1);
  CHECK(placed[1].first == 3);
  CHECK(placed[1].more == 2);
  CHECK(placed[2].first == 5);
  CHECK(placed[2].more == 0);
}

}  // namespace snug::app
