// A naive test that is wrong says so where a student looks: in the sentences, on the timeline, and in what is asked.
#include <doctest/doctest.h>

#include <algorithm>

#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "lesson/subjects/pair/pair.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::session_of;

namespace {

Session at_the_end(const char* situation, const char* test) {
  Session session = session_of("epsilons");
  REQUIRE(session.stage().show_situation(situation).has_value());
  REQUIRE(session.player().choose(0, test).has_value());
  session.jump(session.player().steps());
  return session;
}

int wrong_marks(const Session& session) {
  return static_cast<int>(std::count_if(session.player().marks().begin(), session.player().marks().end(),
                                        [](const Mark& mark) { return mark.kind == Mark::Kind::kWrong; }));
}

}  // namespace

TEST_CASE("the verdict of a naive test is compared with exact arithmetic in its sentence, and crossed if it is wrong") {
  struct Case {
    const char *situation, *test, *says;
    bool wrong;
  };
  for (const Case& one : {Case{"large", "no_epsilon_float", " Wrong: in exact arithmetic the boxes overlap.", true},
                          Case{"small", "absolute_epsilon", " Wrong: in exact arithmetic the boxes are apart.", true},
                          Case{"large", "relative_epsilon_float", " Exact arithmetic says the same.", false}}) {
    CAPTURE(one.test);
    const Session session = at_the_end(one.situation, one.test);
    CHECK(session.telling().caption().ends_with(one.says));
    CHECK((wrong_marks(session) > 0) == one.wrong);
    if (one.wrong) CHECK(session.player().marks().back().kind == Mark::Kind::kWrong);
  }
}

TEST_CASE("what is told of the first row does not call a row of noise a separating axis") {
  Lesson lesson = test::lesson_of("epsilons");
  for (Question& question : lesson.questions)
    if (question.id == "large") question.asks = "first_axis", question.choices.clear();
  Session session = *Session::open(std::move(lesson));
  REQUIRE(session.stage().show_situation("large").has_value());
  REQUIRE(session.player().choose(0, "absolute_epsilon_float").has_value());
  session.go(session.player().steps());
  const Asked* asked = session.conversation().asked();
  REQUIRE(asked != nullptr);
  CHECK(asked->kind->truth(*asked, session.player().run(0)).sentence ==
        "A z × B z is the first row of the table that shows a gap.");
}

TEST_CASE("where a tolerance swallows a gap, the sentence does not deny that the distance is the greater") {
  Session session = session_of("vanishing-axes");
  REQUIRE(session.stage().show_situation("noise").has_value());
  REQUIRE(session.player().choose(0, "relative_epsilon").has_value());
  int swallowed = 0;
  for (const auto& entry : pair_run(session.player().run(0)).trace()) {
    session.jump(static_cast<int>(&entry - pair_run(session.player().run(0)).trace().data()) + 1);
    const auto* axis = std::get_if<query::AxisTested<double, 3>>(&entry.step.fact);
    if (axis == nullptr || axis->skipped || axis->separates) continue;
    const bool greater = axis->distance > axis->radius_a + axis->radius_b;
    swallowed += greater;
    CHECK((session.telling().caption().find(" is not greater than ") == std::string::npos) == greater);
    CHECK(session.telling().caption().ends_with(greater ? "but by no more than the test's tolerance: no gap."
                                                        : ": no gap."));
  }
  CHECK(swallowed > 0);
}
