#include "lesson/situations.hpp"

#include <algorithm>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "lesson/trace_hash.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::kSmallLesson;
using snug::test::open;

namespace {

constexpr std::string_view kSquare = R"(
[[situation]]
name = "square"
title = "A square"
[situation.points]
list = [[-1, -1], [1, -1], [1, 1], [-1, 1], [0, 0]]

[[question]]
id = "square_pair"
algorithm = "ritter"
situation = "square"
before = "pair_chosen"
asks = "axis"
prompt = "Which pair?"
because = "Both are as far apart."
)";

constexpr std::string_view kSection = R"(
[[section]]
title = "Square"
situation = "square"
facts = ["pair_chosen"]
text = "Back to the [first](situation:own), or the [square](situation:square)."
)";

std::string two_situations() { return std::string(kSmallLesson) + std::string(kSquare) + std::string(kSection); }

/// "small.toml:85": the line of the last such words in the small lesson with more.
std::string at_line(const std::string& more, std::string_view words) {
  const std::string text = std::string(kSmallLesson) + more;
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.rfind(words));
  return "small.toml:" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

std::vector<std::string> mistakes_in(const std::string& more) {
  std::vector<std::string> all;
  for (const FileError& mistake : check::checked_draft(std::string(kSmallLesson) + more, "small.toml").mistakes)
    all.push_back(mistake.message());
  return all;
}

std::string only_mistake(const std::string& more) {
  const auto all = mistakes_in(more);
  REQUIRE_MESSAGE(all.size() == 1, (all.empty() ? "none" : all[all.size() - 1]));
  return all.front();
}

std::vector<std::string> asked_in(const Session& session) {
  std::vector<std::string> ids;
  for (const Asked& asked : session.conversation().questions()) ids.push_back(asked.question->id);
  return ids;
}

}  // namespace

TEST_CASE("a lesson has its own situation and others, each with its points and its questions") {
  Session session = open(two_situations());
  CHECK(session.stage().situation() == "own");
  CHECK(session.stage().subject().size() == 6);
  CHECK(asked_in(session) == std::vector<std::string>{"pair", "growth", "again", "number"});
  REQUIRE(session.stage().show_situation("square"));
  CHECK(session.stage().situation() == "square");
  CHECK(session.stage().subject().size() == 5);
  CHECK(session.player().step() == 0);
  CHECK(session.stage().is_own());
  CHECK(asked_in(session) == std::vector<std::string>{"square_pair"});
  CHECK(situation_title(session.lesson(), "square") == "A square");
  CHECK(session.log().situations_waiting(session.stage().situation()) == std::vector<std::string>{"own"});
  const Done none = session.stage().show_situation("circle");
  REQUIRE(!none);
  CHECK(none.error().what == "there is no situation circle");
  CHECK(session.stage().situation() == "square");
}

TEST_CASE("points that were moved in a situation are kept while another is shown, and reset brings back its own") {
  Session session = open(two_situations());
  REQUIRE(session.stage().move(5, {3, 3, 0}));
  REQUIRE(session.stage().show_situation("square"));
  REQUIRE(session.stage().move(4, {0.5, 0, 0}));
  CHECK(!session.stage().is_own());
  REQUIRE(session.stage().show_situation("own"));
  CHECK(session.stage().subject().at(5) == Point3(3, 3, 0));
  CHECK(!session.stage().is_own());
  REQUIRE(session.stage().show_situation("square"));
  CHECK(session.stage().subject().at(4) == Point3(0.5, 0, 0));
  session.stage().reset();
  CHECK(session.stage().situation() == "square");
  CHECK(session.stage().is_own());
  CHECK(session.stage().subject().at(4) == Point3(0, 0, 0));
}

TEST_CASE("a figure of a method's result is that of the situation that is shown") {
  Session session = open(two_situations());
  const auto radius = [&] {
    std::string text;
    for (const Figure& figure : session.player().result(*session.player().method(0)))
      if (figure.key == "radius") text = figure.text;
    return text;
  };
  const std::string own = radius();
  REQUIRE(!own.empty());
  REQUIRE(session.stage().show_situation("square"));
  CHECK(radius() != own);
  REQUIRE(session.stage().show_situation("own"));
  CHECK(radius() == own);
}

TEST_CASE("a lesson that opens at its end begins a situation before the first step, where something is asked there") {
  const auto from_end = [](std::string text) {
    const std::string_view seed = "seed = 5\n";
    return text.insert(text.find(seed) + seed.size(), "start = \"end\"\n");
  };
  Session told = open(from_end(two_situations()));
  CHECK(told.player().previewing());
  REQUIRE(told.stage().show_situation("square"));
  CHECK((told.player().previewing() && told.player().step() == told.player().steps()));

  const std::string_view without_question = kSquare.substr(0, kSquare.find("[[question]]"));
  Session asking = open(from_end(std::string(kSmallLesson) + std::string(without_question) + R"(
[[question]]
id = "first"
algorithm = "ritter"
situation = "square"
before = "pair_chosen"
after = "start"
asks = "axis"
prompt = "Which pair?"
because = "Both are as far apart."
)"));
  CHECK(asking.player().previewing());
  REQUIRE(asking.stage().show_situation("square"));
  CHECK((!asking.player().previewing() && asking.player().step() == 0));
  REQUIRE(asking.conversation().asked() != nullptr);
  CHECK(asking.conversation().asked()->question->id == "first");
}

TEST_CASE("a switch is one entry of undo, and the player stands where it stood in each situation") {
  Session session = open(two_situations());
  session.jump(4);
  REQUIRE(session.stage().show_situation("square"));
  REQUIRE(session.stage().move(4, {0.5, 0, 0}));
  session.stage().undo();
  CHECK(session.stage().situation() == "square");
  CHECK(session.stage().is_own());
  session.stage().undo();
  CHECK(session.stage().situation() == "own");
  CHECK(session.player().step() == 4);
  CHECK(!session.stage().can_undo());
  session.stage().redo();
  CHECK(session.stage().situation() == "square");
  session.stage().redo();
  CHECK(session.stage().subject().at(4) == Point3(0.5, 0, 0));
  CHECK(!session.stage().can_redo());
}

TEST_CASE("a scatter, a task and another algorithm keep to the situation") {
  Session session = open(two_situations());
  REQUIRE(session.stage().show_situation("square"));
  session.stage().scatter(9);
  CHECK(session.stage().situation() == "square");
  CHECK(session.stage().subject().size() == 5);
  session.stage().scatter(5);
  CHECK(session.stage().is_own());
  REQUIRE(session.player().choose(0, "welzl"));
  CHECK(session.stage().situation() == "square");
  REQUIRE(session.stage().set_generator("cube", 9, 2, 3));
  CHECK(session.stage().situation() == "square");
  CHECK(session.stage().subject().size() == 9);
}

TEST_CASE("the section about a situation is the one at hand there, and its steps' section is its own") {
  Session session = open(two_situations());
  CHECK(!section_at(session));
  REQUIRE(session.stage().show_situation("square"));
  CHECK(section_at(session) == 1);
}

TEST_CASE("all situations are played and hashed; without any the hash is as it was") {
  Session session = open(two_situations());
  const auto played = check::play(session);
  REQUIRE(played);
  CHECK(played->sound());
  CHECK(played->not_asked.empty());
  CHECK(std::count_if(played->algorithms.begin(), played->algorithms.end(),
                      [](const auto& one) { return one.situation == "square"; }) == 3);
  Session again = open(two_situations()), small = snug::test::open_small();
  const auto both = trace_hash(again), one = trace_hash(small);
  REQUIRE((both && one));
  CHECK(both->hash != one->hash);
  CHECK(both->steps > one->steps);
}

TEST_CASE("questions of every situation are checked on its own run") {
  CHECK(only_mistake(R"(
[[situation]]
name = "two"
title = "Two points"
[situation.points]
list = [[0, 0], [1, 0]]
[[question]]
id = "grown"
situation = "two"
algorithm = "ritter"
before = "ball_grown"
asks = "point"
prompt = "Which point?"
because = "It lies outside."
)")
            .find("ritter does not take step ball_grown on these points") != std::string::npos);
}

TEST_CASE("mistakes in situations are told with their place") {
  const std::string square(kSquare);
  const std::string lost = square + "\n[[section]]\ntitle = \"x\"\nsituation = \"sqare\"\ntext = \"x\"\n";
  CHECK(only_mistake(lost) == at_line(lost, "situation = \"sqare\"") +
                                  ":13: \"situation\" is none of own or square: sqare; did you mean square?");
  CHECK(only_mistake(square + "\n[[section]]\ntitle = \"x\"\ntext = \"[x](situation:sqare)\"\n")
            .find("links to a situation that is none of own or square: sqare; did you mean square?") !=
        std::string::npos);
  const std::string twin = "\n[[situation]]\nname = \"square\"\ntitle = \"x\"\n[situation.points]\nlist = [[0, 0]]\n";
  const std::string told = only_mistake(square + twin), first = at_line(square, "[[situation]]");
  CHECK(told.find(at_line(square + twin, "name = \"square\"")) == 0);
  CHECK(told.find("there is another situation with the name square, in line " + first.substr(first.find(':') + 1)) !=
        std::string::npos);
  CHECK(only_mistake("\n[[situation]]\nname = \"own\"\ntitle = \"x\"\n[situation.points]\nlist = [[0, 0]]\n")
            .find("the name own is that of the lesson's own situation") != std::string::npos);
  CHECK(only_mistake("\n[[situation]]\nname = \"x\"\ntitle = \"x\"\n").find("lacks [situation.points]") !=
        std::string::npos);
  CHECK(only_mistake("\n[[situation]]\nname = \"x\"\ntitle = \"x\"\n[situation.points]\nmesh = \"bunny\"\n")
            .find("has no mesh but that of the lesson's own: bunny") != std::string::npos);
  CHECK(only_mistake("\n[[situation]]\nname = \"x\"\ntitle = \"x\"\n[situation.points]\nlist = [[0, 1e200]]\n")
            .find("too far out") != std::string::npos);
  CHECK(only_mistake(
            "\n[[situation]]\nname = \"x\"\ntitle = \"x\"\n[situation.boxes]\n[situation.points]\nlist = [[0, 0]]\n")
            .find("[[situation]] has no key \"boxes\"") != std::string::npos);
}
