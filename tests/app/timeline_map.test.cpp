#include "app/timeline_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace snug::app {

TEST_CASE("steps and pixels: there and back, and no step beyond either end") {
  for (const int steps : {1, 7, 58, 1850}) {
    const TimelineMap map{400, 2000, steps};
    for (int step = 0; step <= steps; ++step) REQUIRE(map.step_at(map.x_of(step)) == step);
    CHECK(map.step_at(-50) == 0);
    CHECK(map.step_at(9999) == steps);
  }
  const TimelineMap empty{0, 100, 0};
  CHECK(empty.x_of(0) == 0);
  CHECK(empty.step_at(70) == 0);
}

TEST_CASE("marks with room: all questions, the others apart from each other and from gates") {
  using Kind = lesson::Mark::Kind;
  std::vector<lesson::Mark> marks;
  for (int step = 1; step <= 1000; ++step) marks.push_back({step, step % 400 == 0 ? Kind::kQuestion : Kind::kGrew});
  const TimelineMap map{0, 500, 1000};
  const auto kept = marks_with_room(marks, map, 13);
  CHECK(std::count_if(kept.begin(), kept.end(), [](const auto& m) { return m.kind == Kind::kQuestion; }) == 2);
  CHECK(kept.size() > 25);
  for (std::size_t i = 1; i < kept.size(); ++i) REQUIRE(map.x_of(kept[i].step) - map.x_of(kept[i - 1].step) >= 12.99f);
  const std::vector<lesson::Mark> few{{3, Kind::kGrew}, {500, Kind::kReplaced}};
  CHECK(marks_with_room(few, map, 13).size() == 2);
}

}  // namespace snug::app
