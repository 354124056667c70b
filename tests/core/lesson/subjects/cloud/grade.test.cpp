#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;
using test::open_small;

namespace {

/// The grade of a task on these points that requires this.
Grade graded(const Session& session, std::string_view algorithm, Requirement due) {
  Task task;
  task.algorithm = algorithm;
  task.conditions.push_back(std::move(due));
  return session.stage().subject().grade(session.lesson(), task, session.player().view());
}

Requirement excess(double at_least, std::string over = {}) {
  Requirement due;
  due.figure = "excess", due.at_least = at_least, due.over = std::move(over);
  return due;
}

}  // namespace

TEST_CASE("the task is graded on the points as they stand") {
  Session session = open_small();
  REQUIRE(session.grade().has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->points == 6);
  CHECK(session.grade()->says.find("There are 6 points; the task is for 4.") == 0);
  REQUIRE(session.stage().remove(5).has_value());
  REQUIRE(session.stage().remove(2).has_value());
  CHECK(session.grade()->done);
  CHECK(session.grade()->excess == doctest::Approx(2.25 / 2.05 - 1));
  CHECK(session.grade()->says == "Excess over the optimum: 9.8 %. Done.");
  REQUIRE(session.stage().move(3, {0, 1, 0}).has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->says == "Excess over the optimum: 0.0 %; it must be at least 5 %.");
}

TEST_CASE("what falls short by a hair does not look reached") {
  const Session session = open_small();
  const double percent = 100 * graded(session, "ritter", excess(0)).excess;
  CHECK(graded(session, "ritter", excess(percent)).done);
  CHECK_FALSE(graded(session, "ritter", excess(std::nextafter(percent, 100.0))).done);
  CHECK(graded(session, "ritter", excess(9.8)).says == "Excess over the optimum: 9.756 %; it must be at least 9.8 %.");
}

TEST_CASE("a requirement can be about another algorithm, and an excess over any") {
  const Session session = open_small();
  Requirement support;
  support.figure = "support", support.algorithm = "welzl", support.at_least = support.at_most = 2;
  CHECK(graded(session, "ritter", support).says == "Support set (Welzl): 3 points; it must be 2 points.");
  support.at_least = support.at_most = 3;
  CHECK(graded(session, "ritter", support).done);
  CHECK(graded(session, "ritter", excess(5, "brute_force")).says.find("Excess over Brute force: 9.8 %.") == 0);
  CHECK_FALSE(graded(session, "welzl", excess(5, "brute_force")).done);
}

TEST_CASE("points all in one place solve nothing") {
  Session session = open_small();
  REQUIRE(session.stage().remove(5).has_value());
  REQUIRE(session.stage().remove(4).has_value());
  for (Index i = 0; i < 4; ++i) REQUIRE(session.stage().move(i, {1, 1, 0}).has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->excess == 0);
}

TEST_CASE("the start of a task has as many points as it is for, and its result on the stage") {
  Session session = open_small();
  REQUIRE(session.player().choose(0, "welzl").has_value());
  session.stage().start_task();
  CHECK(session.stage().subject().size() == 4);
  CHECK(session.player().method(0)->name == "ritter");
  CHECK(session.player().step() == session.player().steps());
  CHECK(session.conversation().asked() == nullptr);
  session.stage().undo();
  CHECK(session.stage().subject().size() == 6);
}

TEST_CASE("a lesson without a task has no grade") {
  const auto text = std::string(test::kSmallLesson);
  Session session = test::open(text.substr(0, text.find("[[task]]")));
  CHECK_FALSE(session.grade().has_value());
  session.stage().start_task();
  CHECK(session.stage().subject().size() == 6);
}
