// What the stage shows of a box and a frustum follows from the session's step alone.
#include "app/subjects/frustum/shown.hpp"

#include <doctest/doctest.h>

namespace snug::app {
namespace {

/// A box upright across the left side of a frustum that looks along +x.
lesson::Session frustum_session(const std::string& test, bool asks) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = "frustum_box";
  auto tables = std::make_shared<lesson::BoxTables>();
  tables->boxes.taper = 0.25;
  tables->boxes.boxes[0] = {{2, 2, 0}, Matrix<double, 3>::Identity(), {0.4, 0.2, 0}};
  tables->boxes.boxes[1] = {{2.5, 0, 0}, Matrix<double, 3>::Identity(), {1.5, 4, 0}};
  lesson.tables = std::move(tables);
  lesson.algorithms = {test};
  if (asks) {
    lesson::Question& question = lesson.questions.emplace_back();
    question.id = "p";
    question.gate = {test, "plane_tested", 1, ""};
    question.asks = "p_vertex";
  }
  lesson::Session session = *lesson::Session::open(std::move(lesson));
  session.go(0);
  return session;
}

lesson::Session ball_session(const std::string& test) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = "frustum_sphere";
  auto tables = std::make_shared<lesson::BoxTables>();
  tables->boxes.form = lesson::Form::kBall;
  tables->boxes.taper = 0.25;
  tables->boxes.boxes[0] = {{2, 2, 0}, Matrix<double, 3>::Identity(), {0.4, 0.4, 0}};
  tables->boxes.boxes[1] = {{2.5, 0, 0}, Matrix<double, 3>::Identity(), {1.5, 4, 0}};
  lesson.tables = std::move(tables);
  lesson.algorithms = {test};
  return *lesson::Session::open(std::move(lesson));
}

}  // namespace

TEST_CASE("the planes that a test of a ball moves are drawn as it moves them: out, or wrongly in") {
  for (const auto& [test, by] : {std::pair{"grown_planes", 0.4}, std::pair{"wrong_sign", -0.4}}) {
    CAPTURE(test);
    const std::vector<MovedPlanes> moved = moved_planes(ball_session(test));
    REQUIRE(moved.size() == 2);
    CHECK(moved[1].tested);
    CHECK(moved[1].by == by);
    CHECK_FALSE(moved[0].tested);
    CHECK(moved[0].by == -by);
  }
  CHECK(moved_planes(frustum_session("p_n_vertex", false)).empty());
}

TEST_CASE("a question about a plane shows that plane, and its vertices only when it is answered") {
  lesson::Session session = frustum_session("p_n_vertex", true);
  const FrustumShown asked = frustum_shown_at(session);
  REQUIRE(asked.plane);
  CHECK(asked.plane->plane == 0);
  CHECK(asked.plane_asked);
  CHECK(asked.vertices.empty());
  CHECK_FALSE(asked.verdict);
  REQUIRE(session.conversation().give(lesson::OneChoice{2}));
  const FrustumShown told = frustum_shown_at(session);
  REQUIRE(told.plane);
  CHECK_FALSE(told.plane_asked);
  REQUIRE(told.vertices.size() == 2);
  CHECK(session.stage().subject().name_of(told.vertices[0]) == "−+");
  CHECK(session.stage().subject().name_of(told.vertices[1]) == "+−");
  CHECK(told.verdict == query::Culling::kIntersecting);
  CHECK(told.right == std::vector<Index>{told.vertices[0]});
}

TEST_CASE("corners are marked as they are tested: of one plane at a time, or of all") {
  lesson::Session per_plane = frustum_session("corners_per_plane", false),
                  all = frustum_session("corners_outside", false);
  for (int step = 1; step < per_plane.player().steps(); ++step) {
    per_plane.jump(step);
    const FrustumShown shown = frustum_shown_at(per_plane);
    CHECK(shown.corners.size() == static_cast<std::size_t>((step - 1) % 4 + 1));
    for (const auto& corner : shown.corners) CHECK(corner.plane == (step - 1) / 4);
  }
  all.jump(3);
  CHECK(frustum_shown_at(all).corners.size() == 3);
  all.jump(all.player().steps());
  CHECK(frustum_shown_at(all).corners.size() == 4);
  CHECK(frustum_shown_at(all).verdict == query::Culling::kIntersecting);
}

}  // namespace snug::app
