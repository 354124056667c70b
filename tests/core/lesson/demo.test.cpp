// A state of a demo: how it is read, led to, and made of where a session stands; and its address.
#include "lesson/demo.hpp"

#include "core/lesson/small_lesson.hpp"
#include "lesson/demo_now.hpp"
#include "lesson/demo_reveal.hpp"
#include "lesson/packed_rows.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::open_small;

namespace {

const MeshOf kNoMesh = [](const std::string& name) -> tl::expected<io::PointFile, InputError> {
  return tl::unexpected(InputError{.what = "no mesh " + name});
};

/// The state of a demo's file that has this one alone.
DemoDraft state_read_back(const DemoState& state) {
  return read_demo("version = 1\ntitle = \"T\"\nlecture = \"L\"\n" + state_text(state, "A \"title\"", 0x12), "d.toml");
}

/// Whether a session that the state's own file leads to stands where this one does.
void check_leads_back(const Session& stands) {
  const auto state = state_now(stands, kNoMesh);
  REQUIRE(state);
  const DemoDraft draft = state_read_back(*state);
  REQUIRE(draft.mistakes.empty());
  Session led = open_small();
  REQUIRE(take_state(draft.demo.states.front(), led, kNoMesh));
  CHECK(led.trace_hash() == stands.trace_hash());
  CHECK(led.step() == stands.step());
  CHECK(led.subject().rows() == stands.subject().rows());
}

}  // namespace

TEST_CASE("where a session stands is a state that leads back there: steps, methods, and whatever was edited") {
  Session session = open_small();
  check_leads_back(session);
  session.jump(4);
  REQUIRE(session.choose(0, "welzl"));
  REQUIRE(session.choose(1, "ritter"));
  check_leads_back(session);
  REQUIRE(session.move(2, {0.1, 1.0 / 3, 0}));
  check_leads_back(session);
  CHECK(state_now(session, kNoMesh)->moved.size() == 1);
  REQUIRE(session.add({1, 1, 0}));
  check_leads_back(session);
  CHECK(state_now(session, kNoMesh)->rows.size() == 7);
  REQUIRE(session.set_generator("gaussian", 200, 2, 9));
  check_leads_back(session);
  REQUIRE(session.move(150, {3, 3, 0}));
  check_leads_back(session);
}

TEST_CASE("800 points of one's own survive in an address, after a # that no server is told") {
  Session session = open_small();
  REQUIRE(session.set_generator("cube", 800, 2, 3));
  Rows rows = session.subject().rows();
  for (std::vector<double>& row : rows) row[0] *= 1.0 / 3;
  REQUIRE(session.set_rows(rows));
  check_leads_back(session);
  const std::string address = address_of(*state_now(session, kNoMesh));
  const std::size_t at = address.find("#packed=");
  REQUIRE(at != std::string::npos);
  CHECK(at < 200);
  CHECK(address.size() < 20'000);
  CHECK(unpacked_rows(std::string_view(address).substr(at + 8)) == rows);
}

TEST_CASE("an address and a file name the same things; each in its own words") {
  const DemoState state{.lesson = "small",
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
  DemoState state{.lesson = "small"};
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
  CHECK(session.step() == 0);
  session.go(session.steps());
  CHECK(session.step() == session.steps());
  CHECK(session.asked() == nullptr);
}

TEST_CASE("questions of other algorithms are passed as well: the numbers keep nothing from the class") {
  const std::string keys = "algorithm = \"welzl\"\nbefore = \"finished\"\nasks = \"tightest_order\"\n";
  Session session = test::open(test::small_lesson_with(
      "[[question]]\nid = \"pair\"",
      "[[question]]\nid = \"own\"\nprompt = \"What?\"\nbecause = \"So.\"\n" + keys + "\n[[question]]\nid = \"pair\""));
  session.jump(session.steps());
  REQUIRE(session.comparing());
  pass_questions(session);
  CHECK(session.step() == session.steps());
  CHECK(session.waiting().empty());
  CHECK_FALSE(session.comparing());
  CHECK_FALSE(session.hides_result(*session.method(0)));
}

TEST_CASE("an answer is revealed at the step that decides it, and nothing else is asked") {
  Session session = open_small();
  session.first();
  while (session.asked() == nullptr && session.step() < session.steps()) session.forward();
  REQUIRE(session.asked() != nullptr);
  const std::string question = session.asked()->question->id;
  const int decided = session.asked()->until;
  reveal_answer(session);
  REQUIRE(session.outcome() != nullptr);
  CHECK(session.outcome()->question == question);
  CHECK(session.step() == decided);
  session.acknowledge();
  session.go(session.steps());
  CHECK(session.step() == session.steps());
}

TEST_CASE("a state names its situation, unless it is the lesson's own") {
  const std::string text = test::small_lesson_with("seed = 5", "seed = 5\nsituation_title = \"Six points\"") +
                           "[[situation]]\nname = \"three\"\ntitle = \"Three\"\n"
                           "[situation.points]\ndim = 2\nlist = [[0, 0], [1, 0], [0, 1]]\n";
  Session session = test::open(text);
  CHECK(state_now(session, kNoMesh)->situation.empty());
  REQUIRE(session.show_situation("three"));
  const auto state = state_now(session, kNoMesh);
  CHECK(state->situation == "three");
  CHECK(state->rows.empty());
}
