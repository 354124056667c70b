// A state of a demo: how its file is read and written, and what a press reveals.
#include "lesson/demo.hpp"

#include "core/lesson/small_lesson.hpp"
#include "lesson/demo_reveal.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::open_small;

namespace {

/// The state of a demo's file that has this one alone.
DemoDraft state_read_back(const Place& state) {
  return read_demo("version = 1\ntitle = \"T\"\nlecture = \"L\"\n" + state_text(state, "A \"title\"", 0x12), "d.toml");
}

}  // namespace

TEST_CASE("an address and a file name the same things; each in its own words") {
  const Place state{.lesson = "small",
                    .algorithm = "welzl",
                    .beside = "",
                    .seed = 7,
                    .camera = {2, 0.5, 0},
                    .moved = {{0, 1.5, -2}},
                    .step = 3};
  CHECK(address_of(state) == "?lesson=small&step=3&seed=7&a=welzl&b=none&moved=0,1.5,-2&camera=2,0.5,0");
  CHECK(state_text(state, "A \"title\"", 0x12) == R"([[state]]
hash = "0000000000000012"
slide = "A \"title\""
lesson = "small"
step = 3
seed = 7
algorithm = "welzl"
compare = "none"
moved = "0,1.5,-2"
camera = "2,0.5,0"
shows = ["caption", "numbers", "code"]
notes = "What you say."
)");
}

TEST_CASE("what is packed in a file is read; what is damaged is told with its place") {
  Place state{.lesson = "small"};
  for (int i = 0; i < 70; ++i) state.rows.push_back({0.5 * i, 1});
  CHECK(state_read_back(state).demo.states.front().rows == state.rows);
  const DemoDraft wrong =
      read_demo("version = 1\ntitle = \"T\"\nlecture = \"L\"\n[[state]]\nlesson = \"a\"\nslide = \"b\"\n"
                "notes = \"c\"\npacked = \"?\"\n",
                "d.toml");
  REQUIRE(wrong.mistakes.size() == 1);
  CHECK(wrong.mistakes[0].error().message().find("d.toml:8") == 0);
}

TEST_CASE("questions are passed, and the step stays") {
  Session session = open_small();
  session.go(0);
  pass_questions(session);
  CHECK(session.player().step() == 0);
  session.go(session.player().steps());
  CHECK(session.player().step() == session.player().steps());
  CHECK(session.conversation().asked() == nullptr);
}

TEST_CASE("questions of other algorithms are passed as well: the numbers keep nothing from the class") {
  const std::string keys = "algorithm = \"welzl\"\nbefore = \"finished\"\nasks = \"tightest_order\"\n";
  Session session = test::open(test::small_lesson_with(
      "[[question]]\nid = \"pair\"",
      "[[question]]\nid = \"own\"\nprompt = \"What?\"\nbecause = \"So.\"\n" + keys + "\n[[question]]\nid = \"pair\""));
  session.jump(session.player().steps());
  REQUIRE(session.telling().comparing());
  pass_questions(session);
  CHECK(session.player().step() == session.player().steps());
  CHECK(session.conversation().waiting().empty());
  CHECK_FALSE(session.telling().comparing());
  CHECK_FALSE(session.telling().hides_result(*session.player().method(0)));
}

TEST_CASE("an answer is revealed at the step that decides it, and nothing else is asked") {
  Session session = open_small();
  session.go(0);
  while (session.conversation().asked() == nullptr && session.player().step() < session.player().steps())
    session.forward();
  REQUIRE(session.conversation().asked() != nullptr);
  const std::string question = session.conversation().asked()->question->id;
  const int decided = session.conversation().asked()->until;
  reveal_answer(session);
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK(session.conversation().outcome()->question == question);
  CHECK(session.player().step() == decided);
  session.conversation().acknowledge();
  session.go(session.player().steps());
  CHECK(session.player().step() == session.player().steps());
}
