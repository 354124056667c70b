// Answers that are more than one point or one choice: several points, an order, a number; what wrong ones mean; and two
// questions at one place.
#include "core/lesson/small_lesson.hpp"
#include <algorithm>
#include <array>
#include <cmath>

#include "check/check_lesson.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/order_told.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

using namespace snug;
using namespace snug::lesson;
using test::choice;
using test::point;

namespace {

/// The small lesson with one more question about Ritter's run, before its task.
std::string with_question(const std::string& keys) {
  return test::small_lesson_with("[[task]]", "[[question]]\nid = \"own\"\nprompt = \"What?\"\nbecause = \"So.\"\n" +
                                                 keys + "\n[[task]]");
}

/// Its session, at that question, with every other one skipped.
Session at_own(const std::string& keys) {
  std::string text = with_question(keys);
  text.erase(text.find("[[question]]\nid = \"growth\""),
             text.find("[[question]]\nid = \"again\"") - text.find("[[question]]\nid = \"growth\""));
  Session session = test::open(text);
  for (int turns = 0;
       session.conversation().asked() == nullptr || session.conversation().asked()->question->id != "own"; ++turns) {
    REQUIRE(turns < 1000);
    if (session.conversation().asked() != nullptr) REQUIRE(session.conversation().give({}, false));
    else session.forward();
  }
  return session;
}

const Outcome& outcome_of_own(const Session& session) {
  for (const Outcome& outcome : session.log().outcomes())
    if (outcome.question == "own") return outcome;
  FAIL("it has no outcome");
  return session.log().outcomes().front();
}

constexpr const char* kSupport = "algorithm = \"welzl\"\nbefore = \"finished\"\nasks = \"points\"\n";

Session at_support(const std::string& more = "") {
  Session session = test::open(with_question(kSupport + more));
  REQUIRE(session.player().choose(0, "welzl").has_value());
  session.last();
  REQUIRE(session.conversation().asked() != nullptr);
  return session;
}

}  // namespace

TEST_CASE("several points: all are tapped or typed, and only all of them are right") {
  Session session = at_support();
  CHECK(field_word(*session.conversation().asked()) == "Names");
  REQUIRE(session.conversation().pick(point(0)));
  REQUIRE(session.conversation().pick(point(4)));
  REQUIRE(session.conversation().pick(point(2)));
  REQUIRE(session.conversation().pick(point(2)));  // taken out again
  REQUIRE(session.conversation().picked() != nullptr);
  CHECK(names_handle(*session.conversation().picked(), 4));
  CHECK_FALSE(names_handle(*session.conversation().picked(), 2));
  REQUIRE(session.conversation().commit());
  CHECK(session.conversation().tried() != nullptr);  // two of three
  CHECK_FALSE(session.conversation().pick("P0, P1 and P99"));
  CHECK(session.conversation().answer_says().find("P99") != std::string::npos);
  REQUIRE(session.conversation().pick("p4, P0 and P1"));
  REQUIRE(session.conversation().commit());
  CHECK(outcome_of_own(session).right);
  CHECK(outcome_of_own(session).tries == 2);
  CHECK(outcome_of_own(session).predicted == "P0, P1 and P4");
  CHECK(kept_answers_of(kept_text({session.log().outcomes(), {}})).outcomes.front().given ==
        outcome_of_own(session).given);
}

TEST_CASE("a number is right within its tolerance, with its unit or without") {
  const std::string keys =
      "algorithm = \"ritter\"\nbefore = \"ball_grown\"\nasks = \"number\"\nfigure = \"radius\"\ntolerance = 0.01\n";
  Session session = at_own(keys);
  CHECK(field_word(*session.conversation().asked()) == "Number");
  CHECK(session.telling().asked_figure() == "radius");
  CHECK_FALSE(session.conversation().pick("much"));
  CHECK(session.conversation().answer_says() == "“much” is not a number. Write it like 12 or 2.5.");
  CHECK_FALSE(session.conversation().pick(choice(0)));
  REQUIRE(session.conversation().pick("2"));
  REQUIRE(session.conversation().commit());
  CHECK(session.conversation().tried() != nullptr);
  CHECK_FALSE(session.conversation().pick("2.0"));  // tried already
  REQUIRE(session.conversation().pick("2.245 units"));
  REQUIRE(session.conversation().commit());
  CHECK(outcome_of_own(session).right);
  CHECK(outcome_of_own(session).says == "Radius so far: 2.250 units.");
  const Answer kept = kept_answers_of(kept_text({session.log().outcomes(), {}})).outcomes.back().given;
  CHECK(kept == outcome_of_own(session).given);

  Session other = at_own(keys);
  REQUIRE(other.conversation().give(TypedNumber{2.2601}));
  CHECK_FALSE(outcome_of_own(other).right);
  CHECK_FALSE(
      check::checked_lesson(with_question("algorithm = \"ritter\"\nbefore = \"finished\"\nasks = \"number\"\nfigure = "
                                          "\"excess\"\n"),
                            "x.toml"));  // not a count: without a tolerance nobody could be right
}

TEST_CASE("numbers are read as people type them") {
  CHECK(typed_number("2.5", "") == 2.5);
  CHECK(typed_number(" −3 units ", "units") == -3);
  CHECK(typed_number("12 %", "%") == 12);
  CHECK(typed_number("1,839", "points") == 1839);
  CHECK(typed_number("1,234,567.5", "") == 1234567.5);
  for (const char* text : {"", "2,5", "1,2345", ",123", "1,23,456", "two", "3 points", "nan", "1e999", "--1"})
    CHECK_FALSE(typed_number(text, "%").has_value());
}

TEST_CASE("an order: every choice has its place, and equal ones may change theirs") {
  const std::string keys = "algorithm = \"ritter\"\nbefore = \"extremes_found\"\nasks = \"tightest_order\"\n";
  Session session = test::open(test::small_lesson_with(
      "[[question]]\nid = \"pair\"",
      "[[question]]\nid = \"own\"\nprompt = \"What?\"\nbecause = \"So.\"\n" + keys + "\n[[question]]\nid = \"pair\""));
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().asked()->ordered);
  CHECK(session.telling().comparing());
  // Ritter's circle has radius 2.25; Welzl's and that of brute force are the smallest.
  REQUIRE(session.conversation().pick(choice(0)));
  CHECK_FALSE(session.conversation().commit());
  REQUIRE(session.conversation().pick(choice(0)));
  REQUIRE(session.conversation().pick(choice(2)));
  REQUIRE(session.conversation().pick(choice(1)));
  REQUIRE(session.conversation().pick(choice(0)));
  CHECK(place_in_order(*session.conversation().picked(), 2) == 1);
  CHECK(place_in_order(*session.conversation().picked(), 0) == 3);
  REQUIRE(session.conversation().commit());
  CHECK(outcome_of_own(session).right);
  CHECK_FALSE(session.telling().comparing());
}

TEST_CASE("a wrong order has a second try, and is called an order") {
  Session session = test::open(with_question(
      "algorithm = \"ritter\"\nbefore = \"extremes_found\"\nasks = \"sequence\"\nchoices = [\"1\", \"2\", \"3\"]\n"));
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  for (int i = 0; i < 3; ++i) REQUIRE(session.conversation().pick(choice(i)));  // never shown in order
  REQUIRE(session.conversation().commit());
  CHECK(session.conversation().answer_says() == "Not in that order. Try once more.");
}

TEST_CASE("an order is told line by line, each with its place in the answer; equal lines may change places") {
  Asked asked;
  asked.ordered = true;
  asked.choices = {"test", "project", "report", "project"};
  const std::vector<int> right{1, 3, 0, 2};
  const auto told = [&](std::vector<int> given, bool is_right) {
    Outcome outcome;
    outcome.given = ChoicesInOrder{std::move(given)};
    outcome.right = is_right;
    std::string text;
    for (const auto& [words, place, fine] : order_told(asked, outcome, right))
      text += words + ' ' + std::to_string(place) + (fine ? " right, " : " wrong, ");
    return text;
  };
  CHECK(told({3, 1, 2, 0}, false) == "project 2 right, project 1 right, test 4 wrong, report 3 wrong, ");
  CHECK(told({1, 3, 0, 2}, true) == "project 1 right, project 2 right, test 3 right, report 4 right, ");
  CHECK(told({}, false) == "project 0 wrong, project 0 wrong, test 0 wrong, report 0 wrong, ");  // it was skipped
}

TEST_CASE("lines to be put into order are never shown in order") {
  for (const char* id : {"a", "b", "c", "d", "e", "f"}) {
    std::string text = with_question("algorithm = \"ritter\"\nbefore = \"extremes_found\"\nasks = \"sequence\"\n"
                                     "choices = [\"first\", \"second\", \"third\"]\n");
    text.replace(text.find("\"own\""), 5, '"' + std::string(id) + '"');
    Session session = test::open(text);
    session.go(0);
    REQUIRE(session.conversation().asked() != nullptr);
    const std::vector<std::string> shown = session.conversation().asked()->choices;
    CHECK(shown != std::vector<std::string>{"first", "second", "third"});
    const Answer right = model_answer(*session.conversation().asked(), session.player().run(0));
    std::vector<std::string> told;
    for (const int one : choices_of(right)) told.push_back(shown[one]);
    CHECK(told == std::vector<std::string>{"first", "second", "third"});
    REQUIRE(session.conversation().give(right));
    CHECK(session.log().outcomes().front().right);
  }
}

TEST_CASE("the cheapest is that with the fewest operations") {
  Session session = at_own("algorithm = \"ritter\"\nbefore = \"finished\"\nasks = \"cheapest\"\n");
  const Subject& subject = session.stage().subject();
  const auto operations = [&](const char* name) { return subject.operations(*find_method(session.lesson(), name)); };
  CHECK(operations("ritter") > 0);
  CHECK(operations("ritter") < operations("brute_force"));
  const Answer right = model_answer(*session.conversation().asked(), session.player().run(0));
  const std::array<const char*, 3> names{"ritter", "welzl", "brute_force"};
  for (const char* name : names) CHECK(operations(names[std::get<OneChoice>(right).choice]) <= operations(name));
}

TEST_CASE("a wrong answer is told what it means, at the first try and in the outcome") {
  const std::string keys = "algorithm = \"ritter\"\nbefore = \"pair_chosen\"\nasks = \"point\"\n"
                           "wrong = { P4 = \"P4 is far from the origin, not from another point.\" }\n";
  std::string text = with_question(keys);
  text.erase(text.find("[[question]]\nid = \"pair\""),
             text.find("[[question]]\nid = \"growth\"") - text.find("[[question]]\nid = \"pair\""));
  Session session = test::open(text);
  while (session.conversation().asked() == nullptr) session.forward();
  REQUIRE(session.conversation().asked()->question->id == "own");
  REQUIRE(session.conversation().pick(point(4)));
  REQUIRE(session.conversation().commit());
  CHECK(session.conversation().answer_says() ==
        "Not that one. Try once more. P4 is far from the origin, not from another point.");
  REQUIRE(session.conversation().pick(point(5)));
  REQUIRE(session.conversation().commit());
  CHECK(outcome_of_own(session).because == "So.");
  session.forget_answers();
  session.go(0);
  while (session.conversation().asked() == nullptr) session.forward();
  REQUIRE(session.conversation().give(point(4)));
  CHECK(outcome_of_own(session).because == "P4 is far from the origin, not from another point. So.");
  session.forget_answers();
  session.go(0);
  REQUIRE(session.stage().move(5, {0.4, 0.2, 0}));  // now P4 may be anywhere
  while (session.conversation().asked() == nullptr) session.forward();
  REQUIRE(session.conversation().give(point(4)));
  CHECK(outcome_of_own(session).because == "So.");
}

TEST_CASE(
    "a choice that names handles means what they do: by a tap on one of them, and on the lesson's own run alone") {
  Session session =
      test::open(test::small_lesson_with("because = \"It is farther apart.\"",
                                         "because = \"So.\"\nwrong = { \"the y pair\" = \"It is nearer together.\" }"));
  const auto told = [&](const Answer& answer) {
    session.forget_answers();
    session.go(0);
    while (session.conversation().asked() == nullptr) session.forward();
    REQUIRE(session.conversation().give(answer));
    return session.conversation().outcome()->because;
  };
  CHECK(told(choice(1)) == "It is nearer together. So.");
  CHECK(told(point(4)) == "It is nearer together. So.");
  CHECK(told(point(0)) == "So.");
  REQUIRE(session.stage().move(5, {0.4, 0.2, 0}));
  CHECK(told(choice(1)) == "So.");
}

TEST_CASE("a wrong number and a wrong one of several points are told what they mean") {
  Session session = at_own(
      "algorithm = \"ritter\"\nbefore = \"ball_grown\"\nasks = \"number\"\nfigure = \"radius\"\ntolerance = 0.01\n"
      "wrong = { \"2\" = \"That is the old radius.\" }\n");
  REQUIRE(session.conversation().pick("2.005 units"));
  REQUIRE(session.conversation().commit());
  CHECK(session.conversation().answer_says() == "Not that one. Try once more. That is the old radius.");
  REQUIRE(session.conversation().pick("2.5"));
  REQUIRE(session.conversation().commit());
  CHECK(outcome_of_own(session).because == "That is too much. So.");

  Session several = at_support("wrong = { P0 = \"Never said: P0 is right.\", P2 = \"P2 is inside.\" }\n");
  REQUIRE((several.conversation().pick(point(0)) && several.conversation().pick(point(2))));
  REQUIRE(several.conversation().commit());
  CHECK(several.conversation().answer_says() == "Not those. Try once more. P2 is inside.");
}

TEST_CASE("where the lesson has no words for a wrong answer, it is told which way the right one lies") {
  Session number = at_own(
      "algorithm = \"ritter\"\nbefore = \"ball_grown\"\nasks = \"number\"\nfigure = \"radius\"\ntolerance = 0.01\n");
  REQUIRE((number.conversation().pick("1") && number.conversation().commit()));
  CHECK(number.conversation().answer_says() == "Not that one. Try once more. That is too little.");
  REQUIRE((number.conversation().pick("9") && number.conversation().commit()));
  CHECK(outcome_of_own(number).because == "That is too much. So.");

  Session range = at_own(
      "algorithm = \"ritter\"\nbefore = \"finished\"\nasks = \"figure\"\nfigure = \"radius\"\nbounds = [1, 2, 100]\n");
  REQUIRE((range.conversation().pick(choice(0)) && range.conversation().commit()));
  CHECK(range.conversation().answer_says() == "Not that one. Try once more. It is more than that.");
  REQUIRE((range.conversation().pick(choice(3)) && range.conversation().commit()));
  CHECK(outcome_of_own(range).because == "It is less than that. So.");
}

TEST_CASE("of two questions at one place the first is told there, before the second is asked") {
  for (const bool plays : {false, true}) {
    CAPTURE(plays);
    Session session =
        test::open(with_question("algorithm = \"ritter\"\nbefore = \"ball_grown\"\nafter = \"pair_chosen\"\n"
                                 "asks = \"grows\"\n"));
    session.conversation().play_answers(plays);
    while (session.conversation().asked() == nullptr || session.conversation().asked()->question->id == "pair")
      if (session.conversation().asked() != nullptr) REQUIRE(session.conversation().give({}, false));
      else session.forward();
    const int step = session.player().step();
    REQUIRE(session.conversation().asked()->question->id == "growth");
    REQUIRE(session.conversation().pick(point(4)));
    REQUIRE(session.conversation().commit());
    CHECK(session.player().step() == step);
    CHECK(session.conversation().deciding() == nullptr);
    REQUIRE(session.conversation().outcome() != nullptr);
    CHECK(session.conversation().outcome()->question == "growth");
    CHECK(session.conversation().asked() == nullptr);
    CHECK_FALSE(session.conversation().watch_outcome());  // its step would answer the other one
    REQUIRE(session.conversation().acknowledge());
    REQUIRE(session.conversation().asked() != nullptr);
    CHECK(session.conversation().asked()->question->id == "own");
    CHECK(session.conversation().review("growth"));
    CHECK(session.player().step() == step);
    REQUIRE(session.conversation().acknowledge());
    REQUIRE(session.conversation().asked() != nullptr);
    REQUIRE(session.conversation().pick(choice(0)));
    REQUIRE(session.conversation().commit());
    if (plays) {
      REQUIRE(session.conversation().deciding() != nullptr);
      session.conversation().decide();
    }
    REQUIRE(session.conversation().outcome() != nullptr);
    CHECK(session.conversation().outcome()->question == "own");
    CHECK(session.player().step() > step);
    REQUIRE(session.conversation().acknowledge());
    CHECK(session.conversation().outcome() == nullptr);
    CHECK(session.conversation().asked() == nullptr);
  }
}

TEST_CASE("a fixed answer with a condition is asked only where it holds") {
  const std::string keys =
      "algorithm = \"ritter\"\nbefore = \"radius_checked\"\nasks = \"choice\"\nchoices = [\"yes\", "
      "\"no\"]\nanswer = \"no\"\n[[question.require]]\nfigure = \"excess\"\nat_least = 5\n";
  Session session = test::open(with_question(keys));
  const auto is_asked = [&] {
    const auto& all = session.conversation().questions();
    return std::any_of(all.begin(), all.end(), [](const Asked& asked) { return asked.question->id == "own"; });
  };
  CHECK(is_asked());
  REQUIRE(session.stage().move(4, {0, 1.5, 0}).has_value());  // now Ritter's circle is the smallest
  CHECK_FALSE(is_asked());
  session.stage().undo();
  CHECK(is_asked());
}

TEST_CASE("a task can leave a few handles to be moved, and nothing else counts") {
  const std::string text = test::small_lesson_with("hint = \"Think.\"", "hint = \"Think.\"\nonly = [\"P2\", \"P3\"]");
  Session session = test::open(text);
  CHECK(session.stage().may_move(0));  // it has not begun
  session.stage().start_task();
  CHECK_FALSE(session.stage().may_move(0));
  CHECK(session.stage().may_move(2));
  const Point3 before = session.stage().subject().at(0);
  const Done refused = session.stage().move(0, {5, 5, 0});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().what.find("only P2 and P3 move") != std::string::npos);
  CHECK(session.stage().subject().at(0) == before);
  REQUIRE(session.stage().move(2, {0, -1, 0}).has_value());
  REQUIRE(session.stage().move(3, {0, 2.5, 0}).has_value());
  CHECK(session.grade()->done);
  Rows others = session.stage().subject().rows();
  others[0][0] -= 1;
  REQUIRE(session.stage().set_rows(others).has_value());  // P0 as well
  CHECK_FALSE(session.grade()->done);
  CHECK(session.was_done(0));
}

TEST_CASE("a task is done where a drag ends, not where it passes") {
  const std::string text = test::small_lesson_with("hint = \"Think.\"", "hint = \"Think.\"\nonly = [\"P2\", \"P3\"]");
  Session session = test::open(text);
  session.stage().start_task();
  REQUIRE(session.stage().move(2, {0, -1, 0}).has_value());
  const Point3 before = session.stage().subject().at(3);
  session.stage().begin_drag();
  REQUIRE(session.stage().move(3, {0, 2.5, 0}).has_value());
  CHECK(session.grade()->done);
  CHECK_FALSE(session.was_done(0));
  REQUIRE(session.stage().move(3, before).has_value());
  session.stage().end_drag();
  CHECK_FALSE(session.was_done(0));
  session.stage().begin_drag();
  REQUIRE(session.stage().move(3, {0, 2.5, 0}).has_value());
  session.stage().end_drag();
  CHECK(session.was_done(0));
}

TEST_CASE("a file of version 1 is told what to change, line by line") {
  const std::string old =
      "version = 1\n\n[[question]]\nid = \"a\"\nasks = \"choice\"\nanswer = \"yes\"\n\n[[question]]\nid = "
      "\"b\"\nown_points = true\n\n[task]\nexcess_at_least = 0.1\nsupport_size = 2\n";
  std::vector<std::string> said;
  for (const FileError& mistake : check::checked_draft(old, "old.toml").mistakes) said.push_back(mistake.message());
  REQUIRE(said.size() == 6);
  CHECK(said[0].find("old.toml:1:11: the file is of version 1") == 0);
  CHECK(said[1].find("old.toml:6:10: a choice now says when its answer is true") == 0);
  CHECK(said[2] == "old.toml:10:14: \"own_points\" is gone: write holds = \"here\"");
  CHECK(said[3] == "old.toml:12:1: there can be several tasks now: write [[task]]");
  CHECK(said[4].find("figure = \"excess\" and at_least = 10") != std::string::npos);
  CHECK(said[5].find("equals = 2") != std::string::npos);
}
