// What was answered on the lesson's own points is asked again on others, and both are kept.
#include <doctest/doctest.h>

#include "core/lesson/small_lesson.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/progress.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

/// Plays the run to its end, and gives the model answers to all that it asks.
void play_through(Session& session) {
  session.first();
  for (int turns = 0; session.step() < session.steps() || session.asked() != nullptr; ++turns) {
    REQUIRE(turns < 1000);
    if (session.asked() != nullptr) REQUIRE(session.answer(model_answer(*session.asked(), session.run(0))));
    session.forward();
  }
  while (session.acknowledge()) {
  }
}

}  // namespace

TEST_CASE("on other points each question is open again, and no answer is lost") {
  Session session = test::open_small();
  play_through(session);
  CHECK(session.tally().open == 0);
  const std::size_t before = session.outcomes().size();
  const Progress progress = progress_of(session);
  REQUIRE(session.can_practise());
  REQUIRE(session.practise());
  CHECK(session.seed() != session.own().origin().seed);
  CHECK(session.instance() == session.seed());
  CHECK(session.step() == 0);
  CHECK_FALSE(session.at_summary());
  REQUIRE(session.questions().size() > 0);
  CHECK(session.tally().open == static_cast<int>(session.questions().size()));
  CHECK(session.outcomes().size() == before);
  play_through(session);
  CHECK(session.tally().open == 0);
  CHECK(session.tally().right == static_cast<int>(session.questions().size()));
  CHECK(session.outcomes().size() == before + session.questions().size());
  CHECK(progress_of(session).answered == progress.answered);

  const KeptAnswers kept = kept_answers_of(kept_text(answers_of(session)));
  Session again = test::open_small();
  take_up(again, kept);
  CHECK(again.outcomes().size() == session.outcomes().size());
  CHECK(again.instance() == 0);
  again.scatter(session.seed());
  CHECK(again.instance() == session.seed());  // it is known from the answers
  CHECK(again.tally().open == 0);

  session.undo();  // all of it is one entry
  CHECK(session.seed() == session.own().origin().seed);
  session.reset();
  CHECK(session.instance() == 0);
  CHECK(session.tally().open == 0);
}

TEST_CASE("what is changed by hand is asked nothing anew") {
  Session session = test::open_small();
  play_through(session);
  session.scatter(session.seed() + 5);  // the button that only scatters
  CHECK(session.instance() == 0);
  REQUIRE(session.practise());
  REQUIRE(session.move(0, {0.5, 0.5, 0}).has_value());
  CHECK(session.instance() == 0);
  session.undo();
  CHECK(session.instance() == session.seed());
}
