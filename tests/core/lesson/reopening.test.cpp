#include "lesson/reopening.hpp"

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::choice;
using snug::test::kSmallLesson;
using snug::test::open;
using snug::test::open_small;
using snug::test::point;
using snug::test::small_lesson_with;

namespace {

/// The lesson as it reads now, at the place of an earlier session.
Session reread(const std::string& text, const Session& before) {
  const Reopening place(before);
  Session now = open(text);
  place.take(now);
  return now;
}

std::string algorithm_of(const Session& session) { return name_in(session.lesson(), *session.player().method(0)); }

}  // namespace

TEST_CASE("a lesson that is read anew stays at its algorithm and step, and the end stays the end") {
  const std::string other_words = small_lesson_with("Another paragraph.", "Other words.");
  Session before = open_small();
  REQUIRE(before.player().choose(0, "welzl"));
  REQUIRE(before.player().choose(1, "ritter"));
  before.jump(4);
  const Session now = reread(other_words, before);
  CHECK(now.player().step() == 4);
  CHECK(algorithm_of(now) == "welzl");
  CHECK(now.player().method(1) == find_method(now.lesson(), "ritter"));
  CHECK(plain_text(*paragraphs_of(now.lesson().sections[0]).at(1)) == "Other words.");
  before.jump(before.player().steps());
  const std::string more = small_lesson_with("[0.5, 0.2]]", "[0.5, 0.2], [0.1, 0.1], [0.3, 0.2]]");
  const Session longer = reread(more, before);
  CHECK(longer.stage().subject().size() == 8);
  CHECK(longer.player().step() == longer.player().steps());
}

TEST_CASE("an algorithm that the lesson no longer offers gives way to its first") {
  Session before = open_small();
  REQUIRE(before.player().choose(0, "welzl"));
  const Session now = reread(small_lesson_with("\"welzl\", \"brute_force\"", "\"brute_force\""), before);
  CHECK(algorithm_of(now) == "ritter");
}

TEST_CASE("edits are kept, unless the file has something else on the stage") {
  Session before = open_small();
  REQUIRE(before.stage().move(0, {-3, 0.5, 0}));
  const Session kept = reread(small_lesson_with("title = \"Small\"", "title = \"Little\""), before);
  CHECK(kept.lesson().title == "Little");
  CHECK(kept.stage().subject().at(0).x() == -3);
  CHECK(kept.stage().edited());
  const Session replaced = reread(small_lesson_with("[0, 2.5], [0.5", "[0, 3], [0.5"), before);
  CHECK(replaced.stage().subject().at(0).x() == -2);
  CHECK(replaced.stage().subject().at(4).y() == 3);
  CHECK_FALSE(replaced.stage().edited());
}

TEST_CASE("what was moved in situations that are away is kept, and one that is gone is left out") {
  const std::string square = R"(
[[situation]]
name = "square"
title = "A square"
[situation.points]
list = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
)";
  const std::string text = std::string(kSmallLesson) + square;
  const auto with = [&](std::string_view from, std::string_view to) {
    std::string other = text;
    return other.replace(other.find(from), from.size(), to);
  };
  Session before = open(text);
  REQUIRE(before.stage().move(0, {-3, 0.5, 0}));
  REQUIRE(before.stage().set_float(true));
  REQUIRE(before.stage().show_situation("square"));
  REQUIRE(before.stage().move(2, {2, 2, 0}));
  Session now = reread(with("title = \"Small\"", "title = \"Little\""), before);
  CHECK(now.lesson().title == "Little");
  CHECK(now.stage().situation() == "square");
  CHECK(now.stage().subject().at(2).x() == 2);
  REQUIRE(now.stage().show_situation("own"));
  CHECK(now.stage().subject().at(0).x() == -3);
  CHECK(now.stage().subject().in_float());
  Session moved = reread(with("[0, 2.5], [0.5", "[0, 3], [0.5"), before);  // the file has other points in the first
  CHECK(moved.stage().subject().at(2).x() == 2);
  REQUIRE(moved.stage().show_situation("own"));
  CHECK(moved.stage().subject().at(0).x() == -2);
  REQUIRE(before.stage().show_situation("own"));
  const Session alone = reread(std::string(kSmallLesson), before);
  CHECK(alone.stage().situation() == "own");
  CHECK(alone.stage().subject().at(0).x() == -3);
}

TEST_CASE("points of another seed, of a generator and of a file are kept") {
  const std::string other_words = small_lesson_with("Another paragraph.", "Other words.");
  Session before = open_small();
  before.stage().scatter(17);
  CHECK(reread(other_words, before).stage().subject().rows() == before.stage().subject().rows());
  REQUIRE(before.stage().set_generator("cube", 9, 2, 3));
  const Session generated = reread(other_words, before);
  CHECK(generated.stage().subject().origin().source == "cube");
  CHECK(generated.stage().subject().rows() == before.stage().subject().rows());
  REQUIRE(before.stage().load({2, {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {}}, "mine.xyz"));
  const Session loaded = reread(other_words, before);
  CHECK(loaded.stage().subject().origin().source == "mine.xyz");
  CHECK(loaded.stage().subject().rows() == before.stage().subject().rows());
  before.stage().start_task();
  REQUIRE(before.stage().move(1, {5, 0, 0}));
  const Session task = reread(other_words, before);
  CHECK(task.stage().subject().origin().source == "task");
  CHECK(task.stage().subject().rows() == before.stage().subject().rows());
  CHECK(task.grade()->done == before.grade()->done);
}

TEST_CASE("answers are judged by what the file says now") {
  Session before = open_small();
  before.jump(10);
  REQUIRE(before.conversation().asked() != nullptr);
  REQUIRE(before.conversation().asked()->question->id == "number");
  REQUIRE(before.conversation().give(choice(0)));
  REQUIRE_FALSE(before.conversation().outcome()->right);
  const Session mended = reread(small_lesson_with("answer = \"three\"", "answer = \"one\""), before);
  REQUIRE(mended.conversation().outcome() != nullptr);  // it is told on
  CHECK(mended.conversation().outcome()->right);
  const Session gone = reread(small_lesson_with("id = \"number\"", "id = \"count\""), before);
  for (const Outcome& outcome : gone.log().outcomes()) CHECK(outcome.question != "number");
  const Session other =
      reread(small_lesson_with("asks = \"choice\"\nprompt = \"How many passes?\"\nchoices = [\"one\", "
                               "\"three\"]\nanswer = \"three\"\nholds = \"here\"\nwrong = { one = \"That one finds the "
                               "extremes.\" }",
                               "asks = \"point\"\nprompt = \"Which?\""),
             before);
  for (const Outcome& outcome : other.log().outcomes()) CHECK((outcome.question != "number" || outcome.passed));
}

TEST_CASE("a question that waits for its second try still waits for it") {
  Session before = open_small();
  before.jump(2);
  REQUIRE(before.conversation().asked() != nullptr);
  REQUIRE(before.conversation().asked()->question->id == "growth");
  REQUIRE(before.conversation().pick(point(5)));
  REQUIRE(before.conversation().commit());
  REQUIRE(before.conversation().tried() != nullptr);
  const Session now = reread(std::string(kSmallLesson), before);
  REQUIRE(now.conversation().tried() != nullptr);
  CHECK(*now.conversation().tried() == Answer(OneHandle{5}));
}

TEST_CASE("an answer of several points and a number wait for their second try as well") {
  const auto with_own = [](std::string keys) {
    keys = "[[question]]\nid = \"own\"\nprompt = \"What?\"\nbecause = \"So.\"\n" + keys + "\n[[task]]";
    std::string text = small_lesson_with("[[task]]", keys);
    const auto growth = text.find("[[question]]\nid = \"growth\"");
    return text.erase(growth, text.find("[[question]]\nid = \"again\"") - growth);
  };
  const auto tried_again = [](const std::string& text, const char* algorithm, int step, const auto& give) {
    Session before = open(text);
    REQUIRE(before.player().choose(0, algorithm));
    before.jump(step < 0 ? before.player().steps() - 1 : step);
    REQUIRE(before.conversation().asked() != nullptr);
    give(before);
    REQUIRE(before.conversation().commit());
    REQUIRE(before.conversation().tried() != nullptr);
    const Session now = reread(text, before);
    REQUIRE(now.conversation().tried() != nullptr);
    CHECK(*now.conversation().tried() == *before.conversation().tried());
  };
  tried_again(with_own("algorithm = \"welzl\"\nbefore = \"finished\"\nasks = \"points\"\n"), "welzl", -1,
              [](Session& session) {
                REQUIRE((session.conversation().pick(point(1)) && session.conversation().pick(point(2))));
              });
  tried_again(with_own("algorithm = \"ritter\"\nbefore = \"ball_grown\"\nasks = \"number\"\nfigure = "
                       "\"radius\"\ntolerance = 0.01\n"),
              "ritter", 7, [](Session& session) { REQUIRE(session.conversation().pick("3.25")); });
}

TEST_CASE("another lesson begins where it begins") {
  Session before = open_small();
  before.jump(4);
  const Reopening place(before);
  auto other = check::checked_lesson(kSmallLesson, "other.toml");
  REQUIRE(other.has_value());
  auto now = Session::open(*std::move(other));
  REQUIRE(now.has_value());
  place.take(*now);
  CHECK(now->player().step() == 0);
}
