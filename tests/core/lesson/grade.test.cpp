#include "core/lesson/small_lesson.hpp"

using namespace snug;
using namespace snug::lesson;
using test::open_small;

TEST_CASE("the task is graded on the points as they stand") {
  Session session = open_small();
  REQUIRE(session.grade().has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->points == 6);
  CHECK(session.grade()->says.find("There are 6 points; the task is for 4.") == 0);
  REQUIRE(session.remove(5).has_value());
  REQUIRE(session.remove(2).has_value());
  CHECK(session.grade()->done);
  CHECK(session.grade()->excess == doctest::Approx(2.25 / 2.05 - 1));
  CHECK(session.grade()->says == "Ritter: its circle is 9.8 % larger than the smallest. Done.");
  REQUIRE(session.move(3, {0, 1, 0}).has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->says == "Ritter: its circle is 0.0 % larger than the smallest; at least 5.0 % is asked for.");
}

TEST_CASE("what falls short by a hair does not look reached") {
  Task task;
  task.algorithm = "ritter";
  task.points = 5;
  Session session = open_small();
  REQUIRE(session.remove(5).has_value());
  const double excess = session.grade()->excess;
  task.excess_at_least = std::nextafter(excess, 1.0);
  CHECK_FALSE(grade(task, session.points(), 1).done);
  CHECK(grade(task, session.points(), 1).says ==
        "Ritter: its circle is 9.75 % larger than the smallest; at least 9.8 % is asked for.");
  task.excess_at_least = excess;
  CHECK(grade(task, session.points(), 1).done);
  CHECK(grade(task, session.points(), 1).says == "Ritter: its circle is 9.8 % larger than the smallest. Done.");
}

TEST_CASE("how many points hold the smallest ball can be asked for") {
  Task task;
  task.algorithm = "aabb_center";
  task.points = 6;
  task.support_size = 2;
  Session session = open_small();
  CHECK(grade(task, session.points(), 1).says == "3 points support the smallest circle; it must be 2.");
  task.support_size = 3;
  CHECK(grade(task, session.points(), 1).done);
}

TEST_CASE("points all in one place solve nothing") {
  Session session = open_small();
  REQUIRE(session.remove(5).has_value());
  REQUIRE(session.remove(4).has_value());
  for (Index i = 0; i < 4; ++i) REQUIRE(session.move(i, {1, 1, 0}).has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->excess == 0);
}

TEST_CASE("the start of a task has as many points as it is for, and its result on the stage") {
  Session session = open_small();
  REQUIRE(session.choose(0, "welzl").has_value());
  session.start_task();
  CHECK(session.size() == 4);
  CHECK(session.algorithm(0)->name == "ritter");
  CHECK(session.step() == session.steps());
  CHECK(session.asked() == nullptr);
  session.undo();
  CHECK(session.size() == 6);
}

TEST_CASE("a lesson without a task has no grade") {
  const auto text = std::string(test::kSmallLesson);
  Session session = test::open(text.substr(0, text.find("[task]")));
  CHECK_FALSE(session.grade().has_value());
  session.start_task();
  CHECK(session.size() == 6);
}
