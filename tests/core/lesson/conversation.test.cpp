// A question is a conversation: answered, perhaps tried again, decided, told, acknowledged; and then the next.
#include <doctest/doctest.h>

#include "core/lesson/small_lesson.hpp"
#include "lesson/say.hpp"

using namespace snug::lesson;
using snug::test::choice;
using snug::test::open_small;
using snug::test::point;
using snug::test::small_lesson_with;

namespace {

/// At the question of which point is examined, which any point may answer: P4 is right.
Session at_which_point() {
  Session session = open_small();
  session.jump(2);
  return session;
}

bool give(Session& session, const Answer& answer) { return session.pick(answer) && session.commit(); }

}  // namespace

TEST_CASE("an outcome is told until it is acknowledged, and only then the next question is asked") {
  Session session = open_small();
  session.last();
  REQUIRE(session.answer(choice(0)));
  const Outcome* told = session.outcome();
  REQUIRE(told != nullptr);
  CHECK(session.asked() == nullptr);
  SUBCASE("by a step, which is not taken") {
    const int step = session.step();
    session.forward();
    CHECK(session.step() == step);
  }
  SUBCASE("by acknowledge") {
    REQUIRE(session.acknowledge());
    CHECK_FALSE(session.acknowledge());
  }
  SUBCASE("by going elsewhere") { session.first(); }
  CHECK(session.outcome() == nullptr);
  session.last();
  CHECK(session.asked() != nullptr);
}

TEST_CASE("a first wrong answer is told to be wrong, and nothing else") {
  Session session = at_which_point();
  REQUIRE(session.asked() != nullptr);
  const int step = session.step();
  const std::string caption = session.caption();
  REQUIRE(give(session, point(3)));
  CHECK(session.answer_says() == "Not that one. Try once more.");
  CHECK(standing_of(session.outcome_of(session.questions()[1])) == Standing::kOpen);
  CHECK(session.outcome() == nullptr);
  CHECK(session.step() == step);
  CHECK(session.caption() == caption);
  REQUIRE(session.tried() != nullptr);
  CHECK(session.tried()->value == 3);
  CHECK_FALSE(session.pick(point(3)));
  CHECK(session.answer_says() == "You have tried that one. Try another.");
  SUBCASE("right on the second try") {
    REQUIRE(give(session, point(4)));
    CHECK(session.outcome()->right);
    CHECK(session.outcome()->tries == 2);
    CHECK(verdict_text(*session.outcome()) == "Correct on the second try");
    CHECK(session.tally().right == 1);
    CHECK(session.tally().second == 1);
  }
  SUBCASE("wrong at the second") {
    REQUIRE(give(session, point(1)));
    CHECK_FALSE(session.outcome()->right);
    CHECK(session.outcome()->tries == 2);
    CHECK(session.outcome()->predicted == "P1");
    CHECK(session.tally().wrong == 1);
    REQUIRE(session.can_show_answer());
    CHECK_FALSE(session.answer_shown());
    REQUIRE(session.show_answer());
    CHECK(session.answer_shown());
  }
  SUBCASE("skipped") {
    REQUIRE(session.skip());
    CHECK(session.outcome()->skipped);
    CHECK(session.outcome()->tries == 0);
    CHECK_FALSE(session.can_show_answer());
  }
  SUBCASE("forgotten with the points") {
    REQUIRE(session.move(2, {0.1, 1, 0}).has_value());
    CHECK(session.tried() == nullptr);
  }
}

TEST_CASE("of two answers there is no second try") {
  Session session = open_small();
  session.last();
  REQUIRE(session.asked()->choices.size() == 2);
  REQUIRE(give(session, choice(1)));
  REQUIRE(session.outcome() != nullptr);
  CHECK_FALSE(session.outcome()->right);
  CHECK(session.outcome()->tries == 1);
}

TEST_CASE("the key that goes on skips a question at its second press") {
  Session session = at_which_point();
  const int step = session.step();
  REQUIRE(session.pass_by());
  CHECK(session.answer_says() == "Press again to skip this question.");
  CHECK(standing_of(session.outcome_of(session.questions()[1])) == Standing::kOpen);
  CHECK(session.step() == step);
  SUBCASE("at once") {
    REQUIRE(session.pass_by());
    REQUIRE(session.outcome() != nullptr);
    CHECK(session.outcome()->skipped);
    CHECK(standing_of(session.outcome()) == Standing::kSkipped);
    CHECK_FALSE(session.pass_by());  // it is told
  }
  SUBCASE("not after an answer was chosen in between") {
    REQUIRE(session.pick(point(3)));
    REQUIRE(session.pass_by());
    CHECK(standing_of(session.outcome_of(session.questions()[1])) == Standing::kOpen);
  }
}

TEST_CASE("what lies between a question and its outcome is played where that is wanted") {
  Session session = at_which_point();
  const int from = session.step(), until = session.asked()->until;
  REQUIRE(until - from == 6);
  session.play_answers(true);
  REQUIRE(give(session, point(4)));
  REQUIRE(session.deciding() != nullptr);
  CHECK(session.step() == from);
  CHECK(session.outcome() == nullptr);
  CHECK(session.asked() == nullptr);
  SUBCASE("step by step") {
    for (int step = from + 1; step < until; ++step) {
      session.forward();
      CHECK(session.step() == step);
      CHECK(session.deciding() != nullptr);
      CHECK(session.outcome() == nullptr);
    }
    session.forward();
  }
  SUBCASE("to its end at once") { session.decide(); }
  SUBCASE("and no farther") { session.last(); }
  CHECK(session.step() == until);
  CHECK(session.deciding() == nullptr);
  REQUIRE(session.outcome() != nullptr);
  CHECK(session.outcome()->right);
  REQUIRE(session.watch_outcome());
  CHECK(session.step() == from);
  CHECK(session.outcome() == nullptr);
  session.decide();
  CHECK(session.outcome() != nullptr);
}

TEST_CASE("who goes elsewhere on the way to an outcome has it counted and not told") {
  Session session = at_which_point();
  session.play_answers(true);
  REQUIRE(give(session, point(4)));
  session.forward();
  SUBCASE("back") { session.first(); }
  SUBCASE("by an edit") { REQUIRE(session.move(5, {0.4, 0.2, 0}).has_value()); }
  CHECK(session.deciding() == nullptr);
  CHECK(session.outcome() == nullptr);
  CHECK(session.tally().right == 1);
}

TEST_CASE("a lesson ends with a summary once nothing is open, and each line of it leads back") {
  Session session = open_small();
  const auto all = static_cast<int>(session.questions().size());
  session.jump(session.steps());
  CHECK(session.tally().open == all);  // what a jump passed is open
  CHECK_FALSE(session.at_summary());
  CHECK(session.score().empty());
  session.first();
  session.last();
  REQUIRE(session.skip());
  session.acknowledge();
  snug::test::play_to_end(session);
  session.acknowledge();
  REQUIRE(session.at_summary());
  CHECK(session.tally().right == all - 1);
  CHECK(standing_text(session.outcome_of(session.questions()[0])) == "skipped");
  CHECK(standing_text(session.outcome_of(session.questions()[1])) == "right");
  REQUIRE(session.review(session.questions()[1].question->id));
  REQUIRE(session.outcome() != nullptr);
  CHECK(session.outcome()->right);
  CHECK(session.step() == session.questions()[1].until);
  session.acknowledge();
  session.last();
  REQUIRE(session.at_summary());
  session.close_summary();
  CHECK_FALSE(session.at_summary());
  session.forget_answers();
  CHECK(session.tally().open == all);
}

TEST_CASE("a jump to the end of a lesson that opens there leads to its summary, if every question was answered") {
  Session session = snug::test::open(small_lesson_with("seed = 5", "seed = 5\nstart = \"end\""));
  session.first();
  snug::test::play_to_end(session);
  session.acknowledge();
  REQUIRE(session.at_summary());
  Session later = snug::test::open(small_lesson_with("seed = 5", "seed = 5\nstart = \"end\""));
  later.jump(later.steps());
  CHECK(later.previewing());
  later.take_up_answers(session.outcomes());
  later.jump(later.steps());
  CHECK_FALSE(later.previewing());
  CHECK(later.at_summary());
}

TEST_CASE("a summary's line is the prompt, or of a long one the sentence that asks") {
  CHECK(short_prompt("Which point is next? Tap it.") == "Which point is next? Tap it.");
  const std::string long_one =
      "The points are tested in order, from 0 to 1.5 units. Which of them is the first outside? Tap it.";
  CHECK(short_prompt(long_one) == "Which of them is the first outside?");
  const std::string told =
      "The first plane is the left one, and its normal points out. Tap the vertex farthest along it.";
  CHECK(short_prompt(told) == "Tap the vertex farthest along it.");
  const std::string one = "Which of the fourteen points that were tested so far is the one that lies farthest out?";
  CHECK(short_prompt(one) == one);
}

TEST_CASE("a summary names the algorithms whose questions are still open") {
  const std::string other = R"([[question]]
id = "other"
algorithm = "welzl"
before = "finished"
asks = "choice"
prompt = "Is it the smallest?"
choices = ["yes", "no"]
answer = "yes"
holds = "always"
because = "Welzl's is."

[[task]])";
  Session session = snug::test::open(snug::test::small_lesson_with("[[task]]", other));
  snug::test::play_to_end(session);
  while (session.acknowledge()) {
  }
  REQUIRE(session.at_summary());
  REQUIRE(session.waiting().size() == 1);
  CHECK(session.waiting().front()->name == "welzl");
  REQUIRE(session.choose(0, "welzl").has_value());
  CHECK(session.waiting().empty());
  session.first();
  snug::test::play_to_end(session);
  REQUIRE(session.choose(0, "ritter").has_value());
  CHECK(session.waiting().empty());
  REQUIRE(session.move(0, {-2.5, 0, 0}).has_value());
  session.forget_answers();
  CHECK(session.waiting().empty());  // elsewhere the question may not arise
}

TEST_CASE("while a prediction is asked, nothing is told of what the run comes to") {
  Session session = snug::test::open_small();
  session.first();
  REQUIRE(session.grade().has_value());
  const std::string stands = session.grade()->says;
  while (session.asked() == nullptr) session.forward();
  REQUIRE(session.predicting());
  CHECK(session.grade()->says == kTaskWaits);
  CHECK(stands != kTaskWaits);
  for (const Rival& rival : session.rivals()) CHECK(session.hides_result(*rival.method));
  for (const Figure& figure : session.figures())
    if (figure.key == "excess") CHECK_FALSE(figure.known);
  REQUIRE(session.skip());
  session.acknowledge();
  if (session.asked() == nullptr)
    for (const Rival& rival : session.rivals())
      CHECK(session.hides_result(*rival.method) == (rival.method == session.method(0)));  // more is asked later
  snug::test::play_to_end(session);
  while (session.acknowledge()) {
  }
  for (const Rival& rival : session.rivals()) CHECK_FALSE(session.hides_result(*rival.method));
}
