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
  session.go(0);
  for (int turns = 0; session.player().step() < session.player().steps() || session.conversation().asked() != nullptr;
       ++turns) {
    REQUIRE(turns < 1000);
    if (session.conversation().asked() != nullptr)
      REQUIRE(session.conversation().give(model_answer(*session.conversation().asked(), session.player().run(0))));
    session.forward();
  }
  while (session.conversation().acknowledge()) {
  }
}

}  // namespace

TEST_CASE("on other points each question is open again, and no answer is lost") {
  Session session = test::open_small();
  play_through(session);
  CHECK(session.conversation().tally().open == 0);
  const std::size_t before = session.log().outcomes().size();
  const Progress progress = progress_of(session);
  REQUIRE(session.conversation().can_practise());
  REQUIRE(session.conversation().practise());
  CHECK(session.stage().subject().origin().seed != session.stage().own().origin().seed);
  CHECK(session.conversation().instance() == session.stage().subject().origin().seed);
  CHECK(session.player().step() == 0);
  CHECK_FALSE(session.conversation().at_summary());
  REQUIRE(session.conversation().questions().size() > 0);
  CHECK(session.conversation().tally().open == static_cast<int>(session.conversation().questions().size()));
  CHECK(session.log().outcomes().size() == before);
  play_through(session);
  CHECK(session.conversation().tally().open == 0);
  CHECK(session.conversation().tally().right == static_cast<int>(session.conversation().questions().size()));
  CHECK(session.log().outcomes().size() == before + session.conversation().questions().size());
  CHECK(progress_of(session).answered == progress.answered);

  const KeptAnswers kept = kept_answers_of(kept_text(answers_of(session)));
  Session again = test::open_small();
  take_up(again, kept);
  CHECK(again.log().outcomes().size() == session.log().outcomes().size());
  CHECK(again.conversation().instance() == 0);
  again.stage().scatter(session.stage().subject().origin().seed);
  CHECK(again.conversation().instance() == session.stage().subject().origin().seed);  // it is known from the answers
  CHECK(again.conversation().tally().open == 0);

  session.stage().undo();  // all of it is one entry
  CHECK(session.stage().subject().origin().seed == session.stage().own().origin().seed);
  session.stage().reset();
  CHECK(session.conversation().instance() == 0);
  CHECK(session.conversation().tally().open == 0);
}

TEST_CASE("what is changed by hand is asked nothing anew") {
  Session session = test::open_small();
  play_through(session);
  session.stage().scatter(session.stage().subject().origin().seed + 5);  // the button that only scatters
  CHECK(session.conversation().instance() == 0);
  REQUIRE(session.conversation().practise());
  REQUIRE(session.stage().move(0, {0.5, 0.5, 0}).has_value());
  CHECK(session.conversation().instance() == 0);
  session.stage().undo();
  CHECK(session.conversation().instance() == session.stage().subject().origin().seed);
}

TEST_CASE("practising where no points raise the question changes nothing, and forgets nothing that was undone") {
  // Each of the corners lies outside the circle so far, which hardly ever happens six times with ten points.
  std::string text = test::small_lesson_with(
      "[[-2, 0], [2, 0], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]",
      "[[-2, 0], [2, 0], [0, 1.99], [0, -1.99], [1.5, 1.5], [-1.6, -1.6], [1.7, -1.7], [-1.8, 1.8], [1.9, 1.9], "
      "[-1.95, -1.95]]");
  text.resize(text.find("[[question]]"));
  text += R"([[question]]
id = "sixth"
algorithm = "ritter"
before = "ball_grown"
nth = 6
asks = "point"
prompt = "Which point?"
because = "It lies outside."
)";
  Session session = test::open(text);
  REQUIRE(session.conversation().can_practise());
  REQUIRE(session.stage().move(2, {0, 1.8, 0}).has_value());
  session.stage().undo();
  REQUIRE(session.stage().can_redo());
  const Rows rows = session.stage().subject().rows();
  CHECK_FALSE(session.conversation().practise());
  CHECK(session.stage().subject().rows() == rows);
  CHECK(session.stage().can_redo());
  CHECK(session.conversation().instance() == 0);
}
