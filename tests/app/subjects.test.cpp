// Which subject a lesson is of, and what a subject need not say.
#include "app/subjects.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace snug::app {
namespace {

lesson::Lesson lesson_of(const std::string& volume) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = volume;
  return lesson;
}

/// What is open in it: points, and an algorithm that fits the volume to them.
lesson::Session fitted(const std::string& volume, const std::string& algorithm) {
  lesson::Lesson lesson = lesson_of(volume);
  lesson.points = {.dim = 3, .generate = "clusters", .count = 14};
  lesson.algorithms = {algorithm};
  return *lesson::Session::open(std::move(lesson));
}

}  // namespace

TEST_CASE("every lesson is of one subject; only the charts' has something to cover the stage with") {
  CHECK(subject_of(lesson_of("sphere")).name == "cloud");
  CHECK(subject_of(lesson_of("kdop")).name == "cloud");
  CHECK(subject_of(lesson_of("box_pair")).name == "pair");
  CHECK(subject_of(lesson_of("frustum_box")).name == "frustum");
  lesson::Lesson scene = lesson_of("scene");
  scene.scene.emplace();
  CHECK(subject_of(scene).name == "scene");
  CHECK((subject_of(scene).cover == nullptr));
  lesson::Lesson charts = lesson_of("sphere");
  charts.measures = true;
  CHECK(subject_of(charts).name == "cost");
  CHECK(subject_of(charts).cover({})->shown());
}

TEST_CASE("of a fact without a picture of its own, the points that it names are marked") {
  int marked = 0;
  for (const fit::Algorithm& algorithm : fit::algorithms_of("kdop")) {
    lesson::Session session = fitted("kdop", std::string(algorithm.name));
    const auto view = subject_of(session.lesson()).view();
    for (int step = 1; step < session.steps(); ++step) {
      session.jump(step);
      view->refresh(session, false);
      const fit::Step3& now = session.current(0)->step;
      if (!std::holds_alternative<fit::SlabFound>(now.fact)) continue;
      CHECK(view->shown().spoken_of == lesson::points_named(now, 3));
      marked += static_cast<int>(view->shown().spoken_of.size());
    }
  }
  CHECK(marked > 0);
}

}  // namespace snug::app
