#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;
using test::open_small;

namespace {

struct Of {
  const char* algorithm;
  int points;
};

Grade graded(const Session& session, Of of, double excess_at_least, int support_size) {
  Lesson lesson;
  lesson.subject = &kCloudRow;
  Task& task = lesson.task.emplace();
  task.algorithm = of.algorithm, task.points = of.points;
  auto terms = std::make_shared<CloudTask>();
  terms->excess_at_least = excess_at_least, terms->support_size = support_size;
  task.terms = std::move(terms);
  return grade_points(lesson, *session.subject().points(), 1);
}

}  // namespace

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
  CHECK(session.grade()->says == "Ritter: its circle is 0.0 % larger than the smallest; it must be at least 5.0 %.");
}

TEST_CASE("what falls short by a hair does not look reached") {
  Session session = open_small();
  REQUIRE(session.remove(5).has_value());
  const double excess = session.grade()->excess;
  const auto at_least = [&](double due) { return graded(session, {"ritter", 5}, due, 0); };
  CHECK_FALSE(at_least(std::nextafter(excess, 1.0)).done);
  CHECK(at_least(std::nextafter(excess, 1.0)).says ==
        "Ritter: its circle is 9.75 % larger than the smallest; it must be at least 9.8 %.");
  CHECK(at_least(excess).done);
  CHECK(at_least(excess).says == "Ritter: its circle is 9.8 % larger than the smallest. Done.");
}

TEST_CASE("how many points hold the smallest ball can be asked for") {
  const Session session = open_small();
  CHECK(graded(session, {"aabb_center", 6}, 0, 2).says == "3 points support the smallest circle; it must be 2.");
  CHECK(graded(session, {"aabb_center", 6}, 0, 3).done);
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
  CHECK(session.method(0)->name == "ritter");
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
