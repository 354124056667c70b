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

bool give(Session& session, const Answer& answer) {
  return session.conversation().pick(answer) && session.conversation().commit();
}

}  // namespace

TEST_CASE("an outcome is told until it is acknowledged, and only then the next question is asked") {
  Session session = open_small();
  session.last();
  REQUIRE(session.conversation().give(choice(0)));
  const Outcome* told = session.conversation().outcome();
  REQUIRE(told != nullptr);
  CHECK(session.conversation().asked() == nullptr);
  SUBCASE("by a step, which is not taken") {
    const int step = session.player().step();
    session.forward();
    CHECK(session.player().step() == step);
  }
  SUBCASE("by acknowledge") {
    REQUIRE(session.conversation().acknowledge());
    CHECK_FALSE(session.conversation().acknowledge());
  }
  SUBCASE("by going elsewhere") { session.go(0); }
  CHECK(session.conversation().outcome() == nullptr);
  session.last();
  CHECK(session.conversation().asked() != nullptr);
}

TEST_CASE("a first wrong answer is told to be wrong, and nothing else") {
  Session session = at_which_point();
  REQUIRE(session.conversation().asked() != nullptr);
  const int step = session.player().step();
  const std::string caption = session.telling().caption();
  REQUIRE(give(session, point(3)));
  CHECK(session.conversation().answer_says() == "Not that one. Try once more.");
  CHECK(answer_state_of(session.conversation().outcome_of(session.conversation().questions()[1])) ==
        AnswerState::kOpen);
  CHECK(session.conversation().outcome() == nullptr);
  CHECK(session.player().step() == step);
  CHECK(session.telling().caption() == caption);
  REQUIRE(session.conversation().tried() != nullptr);
  CHECK(*session.conversation().tried() == Answer(OneHandle{3}));
  CHECK_FALSE(session.conversation().pick(point(3)));
  CHECK(session.conversation().answer_says() == "You have tried that one. Try another.");
  SUBCASE("right on the second try") {
    REQUIRE(give(session, point(4)));
    CHECK(session.conversation().outcome()->right);
    CHECK(session.conversation().outcome()->tries == 2);
    CHECK(verdict_text(*session.conversation().outcome()) == "Correct on the second try");
    CHECK(session.conversation().tally().right == 1);
    CHECK(session.conversation().tally().second == 1);
  }
  SUBCASE("wrong at the second") {
    REQUIRE(give(session, point(1)));
    CHECK_FALSE(session.conversation().outcome()->right);
    CHECK(session.conversation().outcome()->tries == 2);
    CHECK(session.conversation().outcome()->predicted == "P1");
    CHECK(session.conversation().tally().wrong == 1);
    REQUIRE(session.conversation().can_show_answer());
    CHECK_FALSE(session.conversation().answer_shown());
    REQUIRE(session.conversation().show_answer());
    CHECK(session.conversation().answer_shown());
  }
  SUBCASE("skipped") {
    REQUIRE(session.conversation().give({}, false));
    CHECK(session.conversation().outcome()->skipped);
    CHECK(session.conversation().outcome()->tries == 0);
    CHECK_FALSE(session.conversation().can_show_answer());
  }
  SUBCASE("forgotten with the points") {
    REQUIRE(session.stage().move(2, {0.1, 1, 0}).has_value());
    CHECK(session.conversation().tried() == nullptr);
  }
}

TEST_CASE("of two answers there is no second try") {
  Session session = open_small();
  session.last();
  REQUIRE(session.conversation().asked()->choices.size() == 2);
  REQUIRE(give(session, choice(1)));
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->tries == 1);
}

TEST_CASE("the key that goes on skips a question at its second press") {
  Session session = at_which_point();
  const int step = session.player().step();
  REQUIRE(session.conversation().pass_by());
  CHECK(session.conversation().answer_says() == "Press again to skip this question.");
  CHECK(answer_state_of(session.conversation().outcome_of(session.conversation().questions()[1])) ==
        AnswerState::kOpen);
  CHECK(session.player().step() == step);
  SUBCASE("at once") {
    REQUIRE(session.conversation().pass_by());
    REQUIRE(session.conversation().outcome() != nullptr);
    CHECK(session.conversation().outcome()->skipped);
    CHECK(answer_state_of(session.conversation().outcome()) == AnswerState::kSkipped);
    CHECK_FALSE(session.conversation().pass_by());  // it is told
  }
  SUBCASE("not after an answer was chosen in between") {
    REQUIRE(session.conversation().pick(point(3)));
    REQUIRE(session.conversation().pass_by());
    CHECK(answer_state_of(session.conversation().outcome_of(session.conversation().questions()[1])) ==
          AnswerState::kOpen);
  }
}

TEST_CASE("what lies between a question and its outcome is played where that is wanted") {
  Session session = at_which_point();
  const int from = session.player().step(), until = session.conversation().asked()->until;
  REQUIRE(until - from == 6);
  session.conversation().play_answers(true);
  REQUIRE(give(session, point(4)));
  REQUIRE(session.conversation().deciding() != nullptr);
  CHECK(session.player().step() == from);
  CHECK(session.conversation().outcome() == nullptr);
  CHECK(session.conversation().asked() == nullptr);
  SUBCASE("step by step") {
    for (int step = from + 1; step < until; ++step) {
      session.forward();
      CHECK(session.player().step() == step);
      CHECK(session.conversation().deciding() != nullptr);
      CHECK(session.conversation().outcome() == nullptr);
    }
    session.forward();
  }
  SUBCASE("to its end at once") { session.conversation().decide(); }
  SUBCASE("and no farther") { session.last(); }
  CHECK(session.player().step() == until);
  CHECK(session.conversation().deciding() == nullptr);
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK(session.conversation().outcome()->right);
  REQUIRE(session.conversation().watch_outcome());
  CHECK(session.player().step() == from);
  CHECK(session.conversation().outcome() == nullptr);
  session.conversation().decide();
  CHECK(session.conversation().outcome() != nullptr);
}

TEST_CASE("who goes elsewhere on the way to an outcome has it counted and not told") {
  Session session = at_which_point();
  session.conversation().play_answers(true);
  REQUIRE(give(session, point(4)));
  session.forward();
  SUBCASE("back") { session.go(0); }
  SUBCASE("by an edit") { REQUIRE(session.stage().move(5, {0.4, 0.2, 0}).has_value()); }
  CHECK(session.conversation().deciding() == nullptr);
  CHECK(session.conversation().outcome() == nullptr);
  CHECK(session.conversation().tally().right == 1);
}

TEST_CASE("a lesson ends with a summary once nothing is open, and each line of it leads back") {
  Session session = open_small();
  const auto all = static_cast<int>(session.conversation().questions().size());
  session.jump(session.player().steps());
  CHECK(session.conversation().tally().open == all);  // what a jump passed is open
  CHECK_FALSE(session.conversation().at_summary());
  CHECK(session.conversation().score().empty());
  session.go(0);
  session.last();
  REQUIRE(session.conversation().give({}, false));
  session.conversation().acknowledge();
  snug::test::play_to_end(session);
  session.conversation().acknowledge();
  REQUIRE(session.conversation().at_summary());
  CHECK(session.conversation().tally().right == all - 1);
  CHECK(answer_state_text(session.conversation().outcome_of(session.conversation().questions()[0])) == "skipped");
  CHECK(answer_state_text(session.conversation().outcome_of(session.conversation().questions()[1])) == "right");
  REQUIRE(session.conversation().review(session.conversation().questions()[1].question->id));
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK(session.conversation().outcome()->right);
  CHECK(session.player().step() == session.conversation().questions()[1].until);
  session.conversation().acknowledge();
  session.last();
  REQUIRE(session.conversation().at_summary());
  session.conversation().close_summary();
  CHECK_FALSE(session.conversation().at_summary());
  session.forget_answers();
  CHECK(session.conversation().tally().open == all);
}

TEST_CASE("a jump to the end of a lesson that opens there leads to its summary, if every question was answered") {
  Session session = snug::test::open(small_lesson_with("seed = 5", "seed = 5\nstart = \"end\""));
  session.go(0);
  snug::test::play_to_end(session);
  session.conversation().acknowledge();
  REQUIRE(session.conversation().at_summary());
  Session later = snug::test::open(small_lesson_with("seed = 5", "seed = 5\nstart = \"end\""));
  later.jump(later.player().steps());
  CHECK(later.player().previewing());
  later.take_up(session.log().outcomes());
  later.jump(later.player().steps());
  CHECK_FALSE(later.player().previewing());
  CHECK(later.conversation().at_summary());
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
  while (session.conversation().acknowledge()) {
  }
  REQUIRE(session.conversation().at_summary());
  REQUIRE(session.conversation().waiting().size() == 1);
  CHECK(session.conversation().waiting().front()->name == "welzl");
  REQUIRE(session.player().choose(0, "welzl").has_value());
  CHECK(session.conversation().waiting().empty());
  session.go(0);
  snug::test::play_to_end(session);
  REQUIRE(session.player().choose(0, "ritter").has_value());
  CHECK(session.conversation().waiting().empty());
  REQUIRE(session.stage().move(0, {-2.5, 0, 0}).has_value());
  session.forget_answers();
  CHECK(session.conversation().waiting().empty());  // elsewhere the question may not arise
}

TEST_CASE("while a prediction is asked, nothing is told of what the run comes to") {
  Session session = snug::test::open_small();
  session.go(0);
  REQUIRE(session.grade().has_value());
  const std::string stands = session.grade()->says;
  while (session.conversation().asked() == nullptr) session.forward();
  REQUIRE(session.telling().predicting());
  CHECK(session.grade()->says == kTaskWaits);
  CHECK(stands != kTaskWaits);
  for (const Rival& rival : session.player().rivals()) CHECK(session.telling().hides_result(*rival.method));
  for (const Figure& figure : session.telling().figures())
    if (figure.key == "excess") CHECK_FALSE(figure.known);
  REQUIRE(session.conversation().give({}, false));
  session.conversation().acknowledge();
  if (session.conversation().asked() == nullptr)
    for (const Rival& rival : session.player().rivals())
      CHECK(session.telling().hides_result(*rival.method) ==
            (rival.method == session.player().method(0)));  // more is asked later
  snug::test::play_to_end(session);
  while (session.conversation().acknowledge()) {
  }
  for (const Rival& rival : session.player().rivals()) CHECK_FALSE(session.telling().hides_result(*rival.method));
}
