#include "core/lesson/small_lesson.hpp"

using namespace snug;
using namespace snug::lesson;
using test::choice;
using test::open_small;
using test::point;
using test::small_lesson_with;

TEST_CASE("gates lock the player until their question is answered") {
  Session session = open_small();
  CHECK(session.player().steps() == 11);
  CHECK(session.player().step() == 0);
  CHECK(session.conversation().asked() == nullptr);
  session.last();
  CHECK(session.player().step() == 1);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->question->id == "pair");
  session.forward();
  session.go(9);
  CHECK(session.player().step() == 1);
  session.go(session.player().step() - 1);
  CHECK(session.player().step() == 0);
  session.last();
  CHECK(session.player().step() == 1);

  REQUIRE(session.conversation().give(choice(0)));
  CHECK(session.player().step() == 2);  // the pair is shown, and the next question stands right behind it
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().asked() == nullptr);
  REQUIRE(session.conversation().acknowledge());
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->question->id == "growth");

  REQUIRE(session.conversation().give(point(4)));
  CHECK(session.player().step() == 8);  // where P4 has made the circle grow
  CHECK(session.conversation().outcome()->says == "P4 lies outside, and the circle grows to it.");
  CHECK(session.conversation().outcome()->from_step == 2);  // from where its working can be watched again
  CHECK(session.conversation().outcome()->step == 8);
  session.go(0);
  session.last();
  CHECK(session.player().step() == 9);  // an answered question does not gate again
  CHECK(session.conversation().outcome() == nullptr);
  session.forget_answers();
  session.go(0);
  session.last();
  CHECK(session.player().step() == 1);
}

TEST_CASE("a lesson plays to its end and keeps every outcome") {
  Session session = open_small();
  test::play_to_end(session);
  CHECK(session.player().step() == session.player().steps());
  REQUIRE(session.log().outcomes().size() == 4);
  for (const Outcome& outcome : session.log().outcomes()) {
    CHECK(outcome.right);
    CHECK_FALSE(outcome.skipped);
    CHECK_FALSE(outcome.because.empty());
  }
}

TEST_CASE("an explicit skip commits; a jump passes, and is asked when the player comes again") {
  Session session = open_small();
  session.jump(9);
  CHECK(session.player().step() == 9);
  REQUIRE(session.log().outcomes().size() == 2);
  CHECK(session.log().outcomes()[0].passed);
  CHECK(session.log().outcomes()[0].skipped);
  session.go(0);
  session.last();
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->question->id == "pair");
  REQUIRE(session.conversation().give({}));
  CHECK(session.log().outcomes().size() == 2);
  CHECK(session.conversation().outcome()->says == "P0 and P1, the x pair, lie farthest apart.");
  session.go(0);
  session.last();
  CHECK(session.conversation().asked()->question->id == "growth");
}

TEST_CASE("steps out of range stay within") {
  Session session = open_small();
  session.go(-5);
  CHECK(session.player().step() == 0);
  session.jump(1000);
  CHECK(session.player().step() == session.player().steps());
  session.forward();
  CHECK(session.player().step() == session.player().steps());
  session.jump(-1);
  CHECK(session.player().step() == 0);
  CHECK(session.player().line() == -1);
}

TEST_CASE("a lesson that starts at its end shows the result and has passed no question") {
  Session session = test::open(small_lesson_with("seed = 5", "seed = 5\nstart = \"end\""));
  CHECK(session.player().previewing());
  CHECK(session.player().step() == session.player().steps());
  CHECK(session.conversation().asked() == nullptr);
  session.last();
  session.jump(session.player().steps());  // an address of that state
  CHECK(session.player().previewing());
  REQUIRE(session.stage().move(5, {3, 3, 0}).has_value());
  CHECK(session.player().previewing());
  CHECK(session.player().step() == session.player().steps());
  CHECK(session.log().outcomes().empty());

  SUBCASE("a step shows the first one") {
    session.forward();
    CHECK(session.player().step() == 1);
    CHECK_FALSE(session.player().previewing());
    REQUIRE(session.conversation().asked() != nullptr);
    CHECK(session.conversation().asked()->question->id == "pair");
  }
  SUBCASE("to scrub to the very beginning shows the points alone") {
    session.go(0);
    CHECK(session.player().step() == 0);
    CHECK_FALSE(session.player().previewing());
  }
  SUBCASE("to scrub back stops at the first gate") {
    session.go(8);
    CHECK(session.player().step() == 1);
    CHECK(session.conversation().asked() != nullptr);
  }
}

TEST_CASE("a lesson that starts at its end and was answered is brought back to its end, not to the preview") {
  const std::string text = small_lesson_with("seed = 5", "seed = 5\nstart = \"end\"");
  Session before = test::open(text);
  before.go(0);
  test::play_to_end(before);
  before.conversation().acknowledge();
  REQUIRE(before.conversation().at_summary());
  Session after = test::open(text);
  after.take_up(before.log().outcomes());
  CHECK(after.player().previewing());
  after.jump(before.player().step());
  CHECK_FALSE(after.player().previewing());
  CHECK(after.conversation().at_summary());
}

TEST_CASE("from the result, a step stops at a question that stands before the first one") {
  std::string text = small_lesson_with("seed = 5", "seed = 5\nstart = \"end\"");
  const std::string_view before = "before = \"pair_chosen\"";
  text.replace(text.find(before), before.size(), "before = \"pair_chosen\"\nafter = \"start\"");
  text.replace(text.find("asks = \"axis\""), 13, "asks = \"point\"");
  Session session = test::open(text);
  REQUIRE(session.player().previewing());
  session.forward();
  CHECK(session.player().step() == 0);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->question->id == "pair");
  session.forward();
  CHECK(session.player().step() == 0);
}

TEST_CASE("at the end the player stays at the end when points change; elsewhere at its step") {
  Session session = open_small();
  session.jump(session.player().steps());
  REQUIRE(session.stage().add({0, 9, 0}).has_value());
  CHECK(session.player().step() == session.player().steps());
  session.jump(3);
  REQUIRE(session.stage().remove(6).has_value());
  CHECK(session.player().step() == 3);
  while (session.stage().subject().size() > 1) REQUIRE(session.stage().remove(0).has_value());
  CHECK(session.player().step() <= session.player().steps());
}

TEST_CASE("gates follow the trace: changed points, another algorithm, and back") {
  Session session = open_small();
  REQUIRE(session.conversation().questions().size() == 4);
  REQUIRE(
      session.stage().move(4, {0, 1.5, 0}).has_value());  // nothing grows any more, and the points are not the lesson's
  REQUIRE(session.conversation().questions().size() == 2);
  CHECK(session.conversation().questions()[0].question->id == "pair");
  CHECK(session.conversation().questions()[1].question->id == "again");
  session.stage().undo();
  CHECK(session.conversation().questions().size() == 4);
  REQUIRE(session.player().choose(0, "welzl").has_value());
  CHECK(session.conversation().questions().empty());
  session.last();
  CHECK(session.player().step() == session.player().steps());
  REQUIRE(session.player().choose(0, "ritter").has_value());
  CHECK(session.conversation().questions().size() == 4);
  for (const Asked& asked : session.conversation().questions()) CHECK(asked.question->gate.algorithm == "ritter");
}

TEST_CASE("marks stand where it matters, in order, and can be walked") {
  Session session = open_small();
  int grew = 0, questions = 0, last = 0;
  for (const Mark& mark : session.player().marks()) {
    CHECK(mark.step >= last);
    last = mark.step;
    grew += mark.kind == Mark::Kind::kGrew;
    questions += mark.kind == Mark::Kind::kQuestion;
  }
  CHECK(grew == 2);  // the first ball, and P4
  CHECK(questions == 4);
  CHECK(session.player().next_mark() == 1);
  session.jump(8);
  CHECK(session.player().previous_mark() == 2);
  CHECK(session.player().next_mark() == 9);

  REQUIRE(session.player().choose(0, "brute_force").has_value());
  int best = 0;
  for (const Mark& mark : session.player().marks()) best += mark.kind == Mark::Kind::kBest;
  CHECK(best >= 1);
  REQUIRE(session.player().choose(0, "welzl").has_value());
  int replaced = 0;
  for (const Mark& mark : session.player().marks()) replaced += mark.kind == Mark::Kind::kReplaced;
  CHECK(replaced >= 3);
}

TEST_CASE("the second algorithm stands at the same share of its own trace") {
  Session session = open_small();
  REQUIRE(session.player().choose(1, "welzl").has_value());
  CHECK(session.player().step_of(1) == 0);
  CHECK(session.player().step_of(1) == 0);
  int before = 0;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    CHECK(session.player().step_of(1) >= before);
    before = session.player().step_of(1);
  }
  CHECK(before == session.player().run(1).steps());
  REQUIRE(session.player().choose(1, "").has_value());
  CHECK(session.player().method(1) == nullptr);
  CHECK(session.telling().figures(1).empty());
}

TEST_CASE("a slot without a method has neither volume nor support") {
  Session session = open_small();
  session.last();
  CHECK(session.player().volume(1) == nullptr);
  CHECK(session.player().support(1).empty());
  REQUIRE(session.player().choose(1, "welzl").has_value());
  REQUIRE(session.player().choose(1, "").has_value());
  CHECK(session.player().support(1).empty());
}

TEST_CASE("a lesson opens without a question before its first step, and the first press asks it") {
  const std::string own = "[[question]]\nid = \"own\"\nalgorithm = \"ritter\"\nbefore = \"extremes_found\"\n"
                          "asks = \"choice\"\nchoices = [\"a\", \"b\"]\nanswer = \"a\"\nholds = \"always\"\n"
                          "prompt = \"Which?\"\nwrong = { b = \"No.\" }\nbecause = \"So.\"\n\n";
  const std::string text = test::small_lesson_with("[[question]]\nid = \"pair\"", own + "[[question]]\nid = \"pair\"");
  for (const bool places : {false, true}) {
    Session session = test::open(text);
    CHECK(session.player().step() == 0);
    CHECK(session.conversation().asked() == nullptr);
    CHECK(session.telling().predicting());  // what would give it away stays hidden
    if (places) session.jump(0);            // an address names the step
    else session.forward();
    REQUIRE(session.conversation().asked() != nullptr);
    CHECK(session.conversation().asked()->question->id == "own");
    CHECK(session.player().step() == 0);
  }
}

TEST_CASE("the revision moves with whatever a view shows, and with nothing else") {
  Session session = open_small();
  session.go(0);
  auto revision = session.revision();
  const auto changed = [&] { return std::exchange(revision, session.revision()) != revision; };
  session.go(0);
  static_cast<void>(session.telling().figures());
  static_cast<void>(session.player().rivals());
  CHECK_FALSE(changed());
  session.forward();
  CHECK(changed());
  session.forward();  // locked
  CHECK_FALSE(changed());
  REQUIRE(session.conversation().give(choice(0)));
  CHECK(changed());
  REQUIRE(session.player().choose(1, "welzl").has_value());
  CHECK(changed());
  session.stage().undo();  // nothing to undo
  CHECK_FALSE(changed());
}

TEST_CASE("a lesson that is opened again takes up its answers") {
  Session left = open_small();
  left.last();
  REQUIRE(left.conversation().give(choice(0)));
  REQUIRE(left.conversation().acknowledge());
  REQUIRE(left.conversation().give(point(4)));
  std::vector<Outcome> outcomes = left.log().outcomes();
  REQUIRE(outcomes.size() == 2);
  outcomes.push_back(outcomes.back());
  outcomes.back().question = "of another lesson";

  Session back = open_small();
  back.take_up(outcomes);
  REQUIRE(back.log().outcomes().size() == 2);
  CHECK(back.log().outcomes()[1].says == left.log().outcomes()[1].says);
  CHECK(back.player().step() == 0);
  CHECK(back.conversation().outcome() == nullptr);  // none was given just now
  back.last();
  CHECK(back.conversation().asked()->question->id == "again");  // the two before it are open no more
}
