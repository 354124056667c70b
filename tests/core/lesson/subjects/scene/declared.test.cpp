// What students do to a scene: they drag a body into a wall, edit the declaration, let a body hop.
#include <doctest/doctest.h>

#include <algorithm>

#include "lesson/lesson.hpp"
#include "lesson/subjects/scene/declared_effects.hpp"
#include "lesson/subjects/scene/effect_words.hpp"
#include "lesson/subjects/scene/scene.hpp"

using namespace snug;

namespace {

/// Two piles on a floor, which sleep before frame 200, and a crane beside them.
constexpr const char* kPiles = R"(version = 2
title = "Piles"
summary = "Two piles."
minutes = 1
volume = "scene"
algorithms = ["sweep_and_prune"]

[points]
dim = 3
list = [[-2, 0.26, 0], [-2, 0.78, 0], [2, 0.26, 0], [2, 0.78, 0]]

[scene]
frames = 200
graph = true

[[scene.body]]
name = "floor"
shape = "box"
half_extents = [9, 0.5, 9]
position = [0, -0.5, 0]
fixed = true

[[scene.body]]
shape = "box"
half_extents = [0.5, 0.25, 0.4]
at_points = true

[[scene.effect]]
effect = "fall"

[[scene.effect]]
effect = "refit"

[[scene.effect]]
effect = "broad_phase"

[[scene.effect]]
effect = "narrow_phase"

[[scene.effect]]
effect = "bounce"
restitution = 0

[[scene.effect]]
effect = "trail"

[[scene.effect]]
effect = "shadow"
called = false

[[section]]
title = "Piles"
text = "Two piles."

[[question]]
id = "rest"
algorithm = "sweep_and_prune"
before = "frame_taken"
nth = 190
asks = "skipped"
prompt = "Which effects are skipped?"
because = "All bodies sleep."

[[question]]
id = "first"
algorithm = "sweep_and_prune"
before = "frame_taken"
asks = "skipped"
prompt = "Which effects are skipped?"
because = "None has run yet."

[[task]]
prompt = "Give each body its shadow, with six effects."
hint = "Which ones does a shadow need?"
model = [[-2, 0.26, 0], [-2, 0.78, 0], [2, 0.26, 0], [2, 0.78, 0]]
effects = ["shadow", "fall"]

[[task.require]]
figure = "shadows"
equals = 4

[[task.require]]
figure = "effects"
at_most = 3
)";

lesson::Session piles() {
  auto read = lesson::read_lesson(kPiles, "piles.toml");
  INFO((read ? "" : read.error().message()));
  REQUIRE(read.has_value());
  auto session = lesson::Session::open(*std::move(read));
  REQUIRE(session.has_value());
  return *std::move(session);
}

std::vector<std::string> names_of(const lesson::Session& session, bool called) {
  std::vector<std::string> names;
  for (const lesson::Switch& one : session.switches())
    if (one.called == called) names.push_back(one.name);
  return names;
}

std::string says_of(const lesson::Session& session, std::string_view effect) {
  for (const lesson::Switch& one : session.switches())
    if (one.name == effect) return one.says;
  return "none";
}

const lesson::SceneRecording& run_of(const lesson::Session& session) { return *lesson::recorded_scene(session, 0); }

int awake_at(const lesson::Session& session, int frame) {
  return run_of(session).awake[static_cast<std::size_t>(frame)];
}

}  // namespace

TEST_CASE("a body that is dragged into a fixed one stands there, and the lesson says that the scene cannot run") {
  lesson::Session session = piles();
  const int steps = session.steps();
  session.begin_drag();
  REQUIRE(session.move(0, {-2, -0.5, 0}).has_value());
  const lesson::SceneFrame* frame = lesson::frame_of(session);
  REQUIRE(frame != nullptr);
  CHECK(frame->bodies.size() == 5);
  CHECK(frame->bodies[1].position[1] == doctest::Approx(-0.5));
  CHECK(session.steps() == 0);
  CHECK(session.caption().find("cannot run") != std::string::npos);
  CHECK(session.caption().find("inside floor") != std::string::npos);
  CHECK(session.grade(0).says.find("inside floor") != std::string::npos);
  CHECK(session.figures(0).empty());
  CHECK(names_of(session, true).size() == 6);  // still there to be edited
  REQUIRE(session.move(0, {-2, 0.3, 0}).has_value());
  session.end_drag();
  CHECK(session.steps() == steps);
  CHECK(session.caption().find("cannot run") == std::string::npos);
  session.undo();
  CHECK(session.steps() == steps);
}

TEST_CASE("a body that is dragged beyond all numbers stays where it was") {
  lesson::Session session = piles();
  const lesson::Point3 before = session.point(0);
  session.begin_drag();
  CHECK_FALSE(session.move(0, {1e13, 0, 0}).has_value());
  CHECK(session.point(0) == before);
  CHECK(session.steps() == 200);
  session.end_drag();
  CHECK_FALSE(session.add({1e13, 0, 0}).has_value());
  CHECK(session.size() == 4);
}

TEST_CASE("an effect that is taken out is never constructed, and what needs it says so") {
  lesson::Session session = piles();
  CHECK(names_of(session, false) == std::vector<std::string>{"shadow"});
  REQUIRE(session.call_for("trail", false).has_value());
  CHECK(names_of(session, false) == std::vector<std::string>{"trail", "shadow"});
  CHECK(session.steps() == 200);
  for (const scene::Tally& tally : run_of(session).tallies) CHECK(tally.effect != "trail");

  REQUIRE(session.call_for("broad_phase", false).has_value());
  CHECK(session.steps() == 0);
  CHECK(session.caption() ==
        "The scene cannot run: narrow phase reads pairs, which no effect of the scene makes: broad phase would.");
  CHECK(says_of(session, "narrow_phase") == "needs pairs, which nobody writes");
  CHECK(says_of(session, "refit").empty());
  CHECK(names_of(session, false) == std::vector<std::string>{"broad_phase", "trail", "shadow"});
  session.undo();
  CHECK(session.steps() == 200);
  CHECK_FALSE(session.call_for("move", false).has_value());  // it comes with fall
  CHECK_FALSE(session.call_for("spin", true).has_value());
}

TEST_CASE("at the start a control declares an effect, and later it switches the effect off") {
  lesson::Session session = piles();
  session.jump(0);
  const auto part = [&](std::string_view name) {
    for (const lesson::Switch& one : session.switches())
      if (one.name == name) return one;
    return lesson::Switch();
  };
  CHECK(session.can_toggle(part("trail")));
  CHECK_FALSE(session.can_toggle(part("move")));
  REQUIRE(session.toggle(part("trail")));
  CHECK_FALSE(part("trail").called);
  session.jump(10);
  REQUIRE(session.toggle(part("shadow")));  // one that is not called for is added at any step
  CHECK(part("shadow").called);
  REQUIRE(session.toggle(part("shadow")));
  CHECK(part("shadow").called);
  CHECK_FALSE(part("shadow").on);
  session.reset();
  CHECK(part("trail").called);
  CHECK_FALSE(part("shadow").called);
}

TEST_CASE("a declaration is part of what is kept, and the lesson's own is not said twice") {
  lesson::Session session = piles();
  const lesson::Rows own = session.subject().rows();
  CHECK(own.size() == 4);
  REQUIRE(session.call_for("shadow", true).has_value());
  const lesson::Rows rows = session.subject().rows();
  REQUIRE(rows.size() == 5);
  CHECK(rows.back() == std::vector<double>(7, 1));
  session.reset();
  CHECK(names_of(session, false).size() == 1);
  REQUIRE(session.set_rows(rows).has_value());
  CHECK(names_of(session, false).empty());
  REQUIRE(session.call_for("shadow", false).has_value());
  CHECK(session.subject().rows() == own);
}

TEST_CASE("each effect says what it did in the frame, and why") {
  lesson::Session session = piles();
  session.jump(0);
  CHECK(says_of(session, "fall") == "has not run yet");
  session.jump(1);
  CHECK(says_of(session, "trail") == "runs: all its inputs are new");
  session.jump(3);
  CHECK(says_of(session, "fall") == "runs: new time");
  CHECK(says_of(session, "refit") == "runs: new poses");
  session.jump(200);
  CHECK(says_of(session, "fall") == "skipped: no body is awake");
  CHECK(says_of(session, "refit") == "skipped: its inputs are unchanged");
  CHECK(session.caption() == "Frame 200: none of 7 effects runs; none of 4 bodies is awake.");
  session.jump(10);
  REQUIRE(session.turn("trail", false));
  session.jump(11);
  CHECK(says_of(session, "trail") == "switched off");
}

TEST_CASE("a tap lets a body hop: its island wakes, the run goes on until it sleeps again, and undo takes it back") {
  lesson::Session session = piles();
  session.jump(0);
  CHECK_FALSE(session.push(1));  // before the first frame bodies are moved
  session.jump(200);
  CHECK(awake_at(session, 200) == 0);
  REQUIRE(session.push(1));
  CHECK(session.step() == 200);
  CHECK(session.steps() > 200);
  CHECK(awake_at(session, 201) == 2);
  CHECK(awake_at(session, session.steps()) == 0);
  session.jump(201);
  CHECK(session.caption().find("2 of 4 bodies are awake") != std::string::npos);
  session.undo();
  CHECK(session.steps() == 200);
  CHECK(awake_at(session, 200) == 0);
}

TEST_CASE("which effects are skipped is worked out from the run") {
  lesson::Session session = piles();
  session.jump(0);
  REQUIRE(session.asked() != nullptr);
  CHECK(session.asked()->choices.size() == 8);
  CHECK(session.asked()->choices.back() == "none of them");
  CHECK(session.answer({lesson::Answer::Kind::kChoice, 1 << 7}));
  CHECK(session.outcome()->right);
  session.jump(189);
  REQUIRE(session.asked() != nullptr);
  CHECK(session.answer({lesson::Answer::Kind::kChoice, (1 << 7) - 1}));
  CHECK(session.outcome()->right);
  CHECK(session.outcome()->happened == "all of them");
}

TEST_CASE("a task asks for a picture with the fewest effects") {
  lesson::Session session = piles();
  session.start_task();
  CHECK_FALSE(session.grade(0).done);
  for (const char* effect : {"trail", "bounce", "narrow_phase", "broad_phase", "refit"})
    REQUIRE(session.call_for(effect, false).has_value());
  CHECK_FALSE(session.grade(0).done);
  REQUIRE(session.call_for("shadow", true).has_value());
  CHECK(session.grade(0).done);  // shadow, fall and move
  REQUIRE(session.call_for("trail", true).has_value());
  CHECK_FALSE(session.grade(0).done);
  const auto solved = session.solve_task(0);
  REQUIRE(solved.has_value());
  CHECK(solved->done);
}

TEST_CASE("the counts beside the stage are those of the scene that the command line runs") {
  const lesson::Session session = piles();
  const auto declaration =
      lesson::declaration_with(lesson::set_of(session), "sweep_and_prune", *session.subject().points(), session.seed());
  REQUIRE(declaration.has_value());
  auto scene = scene::Scene::open(*declaration);
  REQUIRE(scene.has_value());
  const lesson::SceneRecording& run = run_of(session);
  for (int frame = 1; frame <= session.steps(); ++frame) {
    scene->step();
    for (std::size_t i = 0; i < run.tallies.size(); ++i) {
      const lesson::EffectCount& count = run.counts[static_cast<std::size_t>(frame) * run.tallies.size() + i];
      CHECK(count.run == scene->tallies()[i].run);
      CHECK(count.skipped == scene->tallies()[i].skipped);
    }
  }
}
