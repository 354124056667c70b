// Where a scene's points stand, and when they can be moved.
#include "app/subjects/scene/view.hpp"

#include <doctest/doctest.h>

#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

/// A body of points that turns once a second, or one that stands at each point.
lesson::Session turning(bool at_points) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = "scene";
  lesson.points = {.dim = 3, .generate = "gaussian", .count = 12};
  auto set = std::make_shared<lesson::SceneSet>();
  set->frames = 30;
  set->bodies.resize(1);
  set->bodies[0].of_points = !at_points;
  set->bodies[0].at_points = at_points;
  set->effects = {{.name = "spin", .settings = {{"turns_per_second", {1}, ""}}}, {.name = "refit"}};
  lesson.tables = std::move(set);
  lesson.algorithms = {"rebuild"};
  return *lesson::Session::open(std::move(lesson));
}

}  // namespace

TEST_CASE("a point is where its body has come to, and is placed where the scene begins") {
  lesson::Session session = turning(false);
  const auto view = scene_view();
  CHECK(view->shows_points(session));
  session.jump(0);
  CHECK(view->can_move(session));
  CHECK((view->place_of(session, 3) - session.stage().subject().at(3)).norm() < 1e-9);
  session.jump(15);
  CHECK_FALSE(view->can_move(session));
  CHECK((view->place_of(session, 3) - session.stage().subject().at(3)).norm() > 0.1);
}

TEST_CASE("where a body stands at each point, it is drawn in the point's place, and the view holds all frames") {
  lesson::Session session = turning(true);
  const auto view = scene_view();
  CHECK_FALSE(view->shows_points(session));
  CHECK(session.stage().subject().tools().word == "Bodies");
  const fit::Sphere3 room = view->extent(session);
  for (Index i = 0; i < session.stage().subject().size(); ++i) {
    CHECK(view->place_of(session, i) == frame_of(session)->bodies[i].position);
    CHECK((session.stage().subject().at(i) - room.center).cwiseAbs().maxCoeff() <= room.radius);
  }
}

TEST_CASE("the view does not follow bodies that miss the floor and fall for the rest of the run") {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = "scene";
  lesson.points = {.dim = 3, .list = {{0, 1, 0}, {1, 1, 0}}};
  auto set = std::make_shared<lesson::SceneSet>();
  set->frames = 240;
  set->bodies.resize(2);
  set->bodies[0].at_points = true;
  set->bodies[1].body.fixed = true;
  set->bodies[1].body.position = {0, -1, 5};  // beside their way
  set->effects = {{.name = "fall"}, {.name = "refit"}};
  lesson.tables = std::move(set);
  lesson.algorithms = {"rebuild"};
  lesson::Session session = *lesson::Session::open(std::move(lesson));
  session.jump(240);
  CHECK(frame_of(session)->bodies[0].position.y() < -50);
  CHECK(scene_view()->extent(session).radius < 5);
}

}  // namespace snug::app
