// Which subject a lesson is of, and what a subject need not say.
#include "app/subjects.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "fit/catalogue.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

/// What is open in it: points, and an algorithm that fits the volume to them.
lesson::Session fitted(const std::string& volume, const std::string& algorithm) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = volume;
  lesson.points = {.dim = fit::find_algorithm(volume, algorithm)->space ? 3 : 2, .generate = "clusters", .count = 14};
  lesson.algorithms = {algorithm};
  return *lesson::Session::open(std::move(lesson));
}

}  // namespace

TEST_CASE("every subject is seen; only those that measure have something to cover the stage with") {
  for (const lesson::SubjectRow* subject : lesson::subjects()) {
    lesson::Lesson lesson;
    lesson.subject = subject;
    const SubjectRow& row = subject_of(lesson);
    CHECK(row.name == subject->name);
    CHECK((row.cover != nullptr) == (row.name == "cost" || row.name == "criteria" || row.name == "claims"));
    if (row.cover != nullptr) CHECK(row.cover({})->shown());
  }
}

TEST_CASE("of a fact without a picture of its own, the points that it names are marked") {
  int marked = 0;
  for (const fit::Algorithm& algorithm : fit::algorithms_of("kdop")) {
    lesson::Session session = fitted("kdop", std::string(algorithm.name));
    const auto view = subject_of(session.lesson()).view();
    for (int step = 1; step < session.player().steps(); ++step) {
      session.jump(step);
      view->refresh(session, false);
      if (session.player().run(0).fact(step - 1) != fit::SlabFound::kName) continue;
      CHECK(view->shown().spoken_of == session.player().run(0).handles(step - 1));
      marked += static_cast<int>(view->shown().spoken_of.size());
    }
  }
  CHECK(marked > 0);
}

}  // namespace snug::app
