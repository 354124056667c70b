// Answers on the stage beside points: named there until a point is moved.
#include <algorithm>

#include "bench.hpp"
#include "lesson/lesson.hpp"

namespace snug::app {
namespace {

constexpr std::string_view kLesson = R"(version = 2
title = "Beside"
summary = "Two answers."
minutes = 1
start = "end"
algorithms = ["hull/quickhull"]
[points]
dim = 2
list = [[0, 0], [4, 0], [4, 3], [0, 3]]
[[beside]]
is = "right"
name = "right p"
volume = { sphere = { center = [4, 3], radius = 0 } }
[[beside]]
is = "yours"
name = "yours p"
volume = { aabb = { min = [6, 3], max = [7, 5] } }
[[beside]]
is = "given"
name = "edge"
volume = { capsule = { a = [0, 0], b = [4, 3], radius = 0 } }
[[section]]
title = "Beside"
text = "Words."
)";

TEST_CASE("what stands beside is named in view, and goes when a point is moved") {
  auto lesson = lesson::read_lesson(kLesson, "beside.toml");
  REQUIRE(lesson);
  Bench bench(*std::move(lesson));
  const auto in_view = [&](std::string_view words) {
    const auto drawn = bench.drawn_words();
    return std::any_of(drawn.begin(), drawn.end(), [&](const DrawnWords& one) {
      return one.words == words && one.low.x >= 0 && one.high.x <= 800 && one.low.y >= 0 && one.high.y <= 440;
    });
  };
  for (const std::string_view name : {"right p", "yours p", "edge"}) CHECK(in_view(name));
  const Handle point = bench.handle("P0");
  bench.drag(point.x, point.y, 20, -20);
  for (const std::string_view name : {"right p", "yours p", "edge"}) CHECK_FALSE(in_view(name));
}

}  // namespace
}  // namespace snug::app
