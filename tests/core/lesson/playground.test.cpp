// What a lesson takes along to the playground.
#include "lesson/playground.hpp"

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kTwoBoxes = R"(version = 2
title = "Boxes"
summary = "For tests."
minutes = 1
volume = "box_pair"
algorithms = ["sat"]

[boxes]
center = [[0, 0], [5, 0]]
half_extents = [[2, 1], [1, 1]]
turn = [[30], [0]]

[[section]]
title = "One"
text = "Prose."
)";

Session opened_text(std::string_view toml) {
  auto lesson = check::checked_lesson(toml, "test.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  return *Session::open(*std::move(lesson));
}

}  // namespace

TEST_CASE("a cloud takes its points along as they stand on the stage") {
  Session session = opened_text(test::kSmallLesson);
  REQUIRE(session.stage().move(0, {-3, 1, 0}));
  const auto points = points_to_try(session);
  REQUIRE(points.has_value());
  CHECK(points->dim == 2);
  REQUIRE(points->points.size() == static_cast<std::size_t>(session.stage().subject().size()));
  CHECK(points->points[0] == Point3(-3, 1, 0));
  CHECK(playground_text(session) == "Try every volume on these points");
}

TEST_CASE("of two boxes the first takes its vertices along") {
  const Session session = opened_text(kTwoBoxes);
  const auto points = points_to_try(session);
  REQUIRE(points.has_value());
  CHECK(points->points.size() == 4);
  for (const Point3& point : points->points) CHECK(point.norm() == doctest::Approx(std::sqrt(5.0)));
  CHECK(playground_text(session) == "Try every volume on this body");
}
