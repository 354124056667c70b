// What students do to a scene: they drag a body into a wall, edit the declaration, let a body hop.
#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_lesson.hpp"
#include "lesson/lesson.hpp"
#include "lesson/reopening.hpp"
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
  auto read = check::checked_lesson(kPiles, "piles.toml");
  INFO((read ? "" : read.error().message()));
  REQUIRE(read.has_value());
  auto session = lesson::Session::open(*std::move(read));
  REQUIRE(session.has_value());
  return *std::move(session);
}

std::vector<std::string> names_of(const lesson::Session& session, bool called) {
  std::vector<std::string> names;
  for (const lesson::Switch& one : session.player().switches())
    if (one.called == called) names.push_back(one.name);
  return names;
}

std::string says_of(const lesson::Session& session, std::string_view effect) {
  for (const lesson::Switch& one : session.player().switches())
    if (one.name == effect) return one.says;
  return "none";
}

const lesson::SceneRecording& run_of(const lesson::Session& session) { return *lesson::recorded_scene(session, 0); }

int awake_at(const lesson::Session& session, int frame) { return run_of(session).awake[frame]; }

}  // namespace

TEST_CASE("a body that is dragged into a fixed one stands there, and the lesson says that the scene cannot run") {
  lesson::Session session = piles();
  const int steps = session.player().steps();
  session.stage().begin_drag();
  REQUIRE(session.stage().move(0, {-2, -0.5, 0}).has_value());
  const lesson::SceneFrame* frame = lesson::frame_of(session);
  REQUIRE(frame != nullptr);
  CHECK(frame->bodies.size() == 5);
  CHECK(frame->bodies[1].position[1] == doctest::Approx(-0.5));
  CHECK(session.player().steps() == 0);
  CHECK(session.telling().caption().find("cannot run") != std::string::npos);
  CHECK(session.telling().caption().find("inside floor") != std::string::npos);
  CHECK(session.grade(0).says.find("inside floor") != std::string::npos);
  CHECK(session.telling().figures(0).empty());
  CHECK(names_of(session, true).size() == 6);  // still there to be edited
  REQUIRE(session.stage().move(0, {-2, 0.3, 0}).has_value());
  session.stage().end_drag();
  CHECK(session.player().steps() == steps);
  CHECK(session.telling().caption().find("cannot run") == std::string::npos);
  session.stage().undo();
  CHECK(session.player().steps() == steps);
}

TEST_CASE("a body that is dragged beyond all numbers stays where it was") {
  lesson::Session session = piles();
  const lesson::Point3 before = session.stage().subject().at(0);
  session.stage().begin_drag();
  CHECK_FALSE(session.stage().move(0, {1e13, 0, 0}).has_value());
  CHECK(session.stage().subject().at(0) == before);
  CHECK(session.player().steps() == 200);
  session.stage().end_drag();
  CHECK_FALSE(session.stage().add({1e13, 0, 0}).has_value());
  CHECK(session.stage().subject().size() == 4);
}

TEST_CASE("an effect that is taken out is never constructed, and what needs it says so") {
  lesson::Session session = piles();
  CHECK(names_of(session, false) == std::vector<std::string>{"shadow"});
  REQUIRE(session.stage().call_for("trail", false).has_value());
  CHECK(names_of(session, false) == std::vector<std::string>{"trail", "shadow"});
  CHECK(session.player().steps() == 200);
  for (const scene::EffectTally& tally : run_of(session).tallies) CHECK(tally.effect != "trail");

  REQUIRE(session.stage().call_for("broad_phase", false).has_value());
  CHECK(session.player().steps() == 0);
  CHECK(session.telling().caption() ==
        "The scene cannot run: narrow phase reads pairs, which no effect of the scene makes: broad phase would.");
  CHECK(says_of(session, "narrow_phase") == "needs pairs, which no effect writes");
  CHECK(says_of(session, "refit").empty());
  CHECK(names_of(session, false) == std::vector<std::string>{"broad_phase", "trail", "shadow"});
  session.stage().undo();
  CHECK(session.player().steps() == 200);
  CHECK_FALSE(session.stage().call_for("move", false).has_value());  // it comes with fall
  CHECK_FALSE(session.stage().call_for("spin", true).has_value());
}

TEST_CASE("at the start a control declares an effect, and later it switches the effect off") {
  lesson::Session session = piles();
  session.jump(0);
  const auto part = [&](std::string_view name) {
    for (const lesson::Switch& one : session.player().switches())
      if (one.name == name) return one;
    return lesson::Switch();
  };
  CHECK(session.player().can_toggle(part("trail")));
  CHECK_FALSE(session.player().can_toggle(part("move")));
  REQUIRE(session.player().toggle(part("trail")));
  CHECK_FALSE(part("trail").called);
  session.jump(10);
  REQUIRE(session.player().toggle(part("shadow")));  // one that is not called for is added at any step
  CHECK(part("shadow").called);
  REQUIRE(session.player().toggle(part("shadow")));
  CHECK(part("shadow").called);
  CHECK_FALSE(part("shadow").on);
  session.stage().reset();
  CHECK(part("trail").called);
  CHECK_FALSE(part("shadow").called);
}

TEST_CASE("a declaration is part of what is kept, and the lesson's own is not said twice") {
  lesson::Session session = piles();
  const lesson::Rows own = session.stage().subject().rows();
  CHECK(own.size() == 4);
  REQUIRE(session.stage().call_for("shadow", true).has_value());
  const lesson::Rows rows = session.stage().subject().rows();
  REQUIRE(rows.size() == 5);
  CHECK(rows.back() == std::vector<double>(7, 1));
  session.stage().reset();
  CHECK(names_of(session, false).size() == 1);
  REQUIRE(session.stage().set_rows(rows).has_value());
  CHECK(names_of(session, false).empty());
  REQUIRE(session.stage().call_for("shadow", false).has_value());
  CHECK(session.stage().subject().rows() == own);
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
  CHECK(session.telling().caption() == "Frame 200: none of 7 effects runs; none of 4 bodies is awake.");
  session.jump(10);
  REQUIRE(session.player().toggle({.name = "trail"}));
  session.jump(11);
  CHECK(says_of(session, "trail") == "switched off");
}

TEST_CASE("a tap lets a body hop: its island wakes, the run goes on until it sleeps again, and undo takes it back") {
  lesson::Session session = piles();
  session.jump(0);
  CHECK_FALSE(session.player().push(1));  // before the first frame bodies are moved
  session.jump(200);
  CHECK(awake_at(session, 200) == 0);
  REQUIRE(session.player().push(1));
  CHECK(session.player().step() == 200);
  CHECK(session.player().steps() > 200);
  CHECK(awake_at(session, 201) == 2);
  CHECK(awake_at(session, session.player().steps()) == 0);
  session.jump(201);
  CHECK(session.telling().caption().find("2 of 4 bodies are awake") != std::string::npos);
  session.stage().undo();
  CHECK(session.player().steps() == 200);
  CHECK(awake_at(session, 200) == 0);
}

TEST_CASE("which effects are skipped is worked out from the run") {
  lesson::Session session = piles();
  session.jump(0);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->choices.size() == 8);
  CHECK(session.conversation().asked()->choices.back() == "none of them");
  CHECK(session.conversation().give(lesson::SeveralChoices{{7}}));
  CHECK(session.conversation().outcome()->right);
  session.jump(189);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().give(lesson::SeveralChoices{{0, 1, 2, 3, 4, 5, 6}}));
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->happened == "all of them");
}

TEST_CASE("a task asks for a picture with the fewest effects") {
  lesson::Session session = piles();
  session.stage().start_task();
  CHECK_FALSE(session.grade(0).done);
  for (const char* effect : {"trail", "bounce", "narrow_phase", "broad_phase", "refit"})
    REQUIRE(session.stage().call_for(effect, false).has_value());
  CHECK_FALSE(session.grade(0).done);
  REQUIRE(session.stage().call_for("shadow", true).has_value());
  CHECK(session.grade(0).done);  // shadow, fall and move
  REQUIRE(session.stage().call_for("trail", true).has_value());
  CHECK_FALSE(session.grade(0).done);
  const auto solved = session.solve_task(0, session.lesson().tasks[0].model);
  REQUIRE(solved.has_value());
  CHECK(solved->done);
}

TEST_CASE("the counts beside the stage are those of the scene that the command line runs") {
  const lesson::Session session = piles();
  const auto declaration =
      lesson::declaration_with(lesson::set_of(session), "sweep_and_prune", *session.stage().subject().points(),
                               session.stage().subject().origin().seed);
  REQUIRE(declaration.has_value());
  auto scene = scene::Scene::open(*declaration);
  REQUIRE(scene.has_value());
  const lesson::SceneRecording& run = run_of(session);
  for (int frame = 1; frame <= session.player().steps(); ++frame) {
    scene->step();
    for (std::size_t i = 0; i < run.tallies.size(); ++i) {
      const lesson::EffectCount& count = run.counts[frame * run.tallies.size() + i];
      CHECK(count.run == scene->tallies()[i].run);
      CHECK(count.skipped == scene->tallies()[i].skipped);
    }
  }
}

namespace {

lesson::StageFile scene_file_of(const lesson::Session& session) {
  const auto file = session.stage().subject().file();
  REQUIRE(file.has_value());
  return *file;
}

/// The text with a part replaced, all of what stands between two words.
std::string with_changed(std::string text, std::string_view part, std::string_view other) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), other);
}

}  // namespace

TEST_CASE("a scene's file says what the lesson's does, and is read as the same scene") {
  lesson::Session session = piles();
  const std::string own = scene_file_of(session).own;
  CHECK(own.starts_with("[scene]\nframes = 200\n\n[[scene.body]]\nname = \"floor\"\nshape = \"box\"\n"
                        "half_extents = [9, 0.5, 9]\nposition = [0, -0.5, 0]\nfixed = true\n"));
  CHECK(own.find("graph") == std::string::npos);
  CHECK(own.ends_with("[[scene.effect]]\neffect = \"shadow\"\ncalled = false\n"));
  const std::uint64_t trace = session.player().trace_hash();
  REQUIRE(session.stage().set_file(own + "# a comment\n").has_value());
  CHECK(scene_file_of(session).mistakes.empty());
  CHECK(session.player().trace_hash() == trace);
  CHECK(names_of(session, false) == std::vector<std::string>{"shadow"});
  CHECK(session.stage().subject().rows().size() == 4);
  REQUIRE(session.stage().set_file(own).has_value());
  CHECK(scene_file_of(session).runs == own);
}

TEST_CASE("a setting that is typed is seen at once, and all that is typed is one entry of undo") {
  lesson::Session session = piles();
  const std::string own = scene_file_of(session).own;
  const std::uint64_t trace = session.player().trace_hash();
  REQUIRE(session.stage().set_file(with_changed(own, "restitution = 0", "restitution = 0.")).has_value());
  REQUIRE(session.stage().set_file(with_changed(own, "restitution = 0", "restitution = 0.6")).has_value());
  CHECK(session.player().trace_hash() != trace);
  CHECK_FALSE(session.stage().is_own());
  session.stage().end_typing();
  REQUIRE(session.stage().set_file(with_changed(own, "frames = 200", "frames = 60")).has_value());
  CHECK(session.player().steps() == 60);
  CHECK(scene_file_of(session).runs.find("restitution = 0\n") != std::string::npos);
  session.stage().undo();
  CHECK(session.player().steps() == 200);
  CHECK(scene_file_of(session).runs.find("restitution = 0.6\n") != std::string::npos);
  session.stage().undo();
  CHECK(session.player().trace_hash() == trace);
  CHECK_FALSE(session.stage().can_undo());
  session.stage().redo();
  CHECK(scene_file_of(session).runs.find("restitution = 0.6\n") != std::string::npos);
}

TEST_CASE("of a text that cannot run every mistake is named with its line, and the stage keeps the last one that ran") {
  lesson::Session session = piles();
  const std::string own = scene_file_of(session).own;
  const std::uint64_t trace = session.player().trace_hash();
  const std::string broken =
      with_changed(with_changed(with_changed(own, "restitution = 0", "restitution = 7\nfriction = -1\nglue = 2"),
                                "effect = \"trail\"", "effect = \"trail\"\nlength = 2.5"),
                   "fixed = true", "fixed = true\nmass = -3");
  REQUIRE(session.stage().set_file(broken).has_value());
  const lesson::StageFile file = scene_file_of(session);
  CHECK(file.typed == broken);
  CHECK(file.runs == own);
  CHECK(session.player().trace_hash() == trace);
  CHECK(session.player().steps() == 200);
  CHECK(file.mistakes ==
        std::vector<std::string>{"4:1: floor: its mass is negative", "31:1: bounce: \"restitution\" is out of range",
                                 "32:1: bounce: \"friction\" is out of range", "33:1: bounce: has no setting \"glue\"",
                                 "35:1: trail: \"length\" must be a whole number"});
  CHECK(file.heading() == "5 mistakes: the stage shows the last text without any.");
  REQUIRE(session.stage().set_file("[scene\n").has_value());  // no TOML
  CHECK(scene_file_of(session).mistakes.size() == 1);
  REQUIRE(session.stage().set_file("").has_value());
  CHECK(scene_file_of(session).mistakes.front() == "1:1: the file lacks [scene]");
  session.stage().undo();  // all of it was typed in one go
  CHECK(scene_file_of(session).typed == own);
  session.stage().redo();
  CHECK(scene_file_of(session).typed.empty());
  CHECK(session.player().trace_hash() == trace);
}

TEST_CASE("what is typed is not lost when something else is edited") {
  lesson::Session session = piles();
  const std::string broken = with_changed(scene_file_of(session).own, "restitution = 0", "restitution = ");
  REQUIRE(session.stage().set_file(broken).has_value());
  REQUIRE(session.stage().move(0, {-2, 0.4, 0}).has_value());
  CHECK(scene_file_of(session).typed == broken);
  REQUIRE(session.stage().call_for("shadow", true).has_value());
  CHECK(scene_file_of(session).typed == broken);
  CHECK(scene_file_of(session).runs.find("called") == std::string::npos);
  session.stage().reset();
  CHECK(scene_file_of(session).mistakes.empty());
  session.stage().undo();
  CHECK(scene_file_of(session).typed == broken);
}

TEST_CASE("an effect's control is seen in the scene's file, and an effect that is typed in has its control") {
  lesson::Session session = piles();
  const std::string own = scene_file_of(session).own;
  REQUIRE(session.stage().call_for("fall", false).has_value());
  CHECK(scene_file_of(session).runs == with_changed(own, "effect = \"fall\"\n", "effect = \"fall\"\ncalled = false\n"));
  CHECK(scene_file_of(session).own == scene_file_of(session).runs);  // which the rows say
  CHECK(session.stage().subject().rows().size() == 5);
  REQUIRE(session.stage().call_for("fall", true).has_value());
  CHECK(scene_file_of(session).runs == own);
  CHECK(session.stage().subject().rows().size() == 4);
  REQUIRE(session.stage().set_file(own + "\n[[scene.effect]]\neffect = \"projection_rays\"\n").has_value());
  CHECK(scene_file_of(session).mistakes.empty());
  const std::vector<std::string> called = names_of(session, true);
  CHECK(std::find(called.begin(), called.end(), "projection_rays") != called.end());
  REQUIRE(session.stage().call_for("projection_rays", false).has_value());
  CHECK(scene_file_of(session).runs.ends_with("effect = \"projection_rays\"\ncalled = false\n"));
  const std::size_t bodies = own.find("[[scene.effect]]");
  REQUIRE(session.stage().set_file(own.substr(0, bodies)).has_value());  // no effect at all
  CHECK(scene_file_of(session).mistakes.empty());
  CHECK(names_of(session, true).empty());
  CHECK(session.player().steps() == 200);
}

TEST_CASE("a scene's file keeps bodies at the places that are dragged") {
  lesson::Session session = piles();
  const std::string own = scene_file_of(session).own;
  REQUIRE(session.stage().set_file(with_changed(own, "at_points = true\n", "")).has_value());
  REQUIRE_FALSE(scene_file_of(session).mistakes.empty());  // at the origin it is inside the floor as well
  CHECK(scene_file_of(session).mistakes.front().starts_with("1:1: no body has \"at_points = true\""));
  REQUIRE(session.stage().set_file(with_changed(own, "frames = 200", "frames = 2000")).has_value());
  CHECK(scene_file_of(session).mistakes.empty());
  CHECK(session.player().steps() == 2000);
}

TEST_CASE("a lesson's file is told of every broken setting of its scene at once") {
  std::string broken = with_changed(kPiles, "restitution = 0", "restitution = 7\nglue = 2");
  broken = with_changed(broken, "effect = \"trail\"", "effect = \"trail\"\nlength = 1");
  const lesson::Draft draft = check::checked_draft(broken, "piles.toml");
  std::vector<std::string> says;
  for (const lesson::FileError& mistake : draft.mistakes) says.push_back(mistake.what);
  CHECK(says == std::vector<std::string>{"bounce: \"restitution\" is out of range", "bounce: has no setting \"glue\"",
                                         "trail: \"length\" is out of range"});
}

TEST_CASE("a lesson that is read anew keeps the scene that was typed") {
  lesson::Session before = piles();
  const std::string own = scene_file_of(before).own;
  const std::string runs = with_changed(own, "frames = 200", "frames = 60"),
                    typed = with_changed(own, "frames = 200", "frames = six");
  REQUIRE(before.stage().set_file(runs).has_value());
  REQUIRE(before.stage().set_file(typed).has_value());
  lesson::Session now = piles();
  lesson::Reopening(before).take(now);
  CHECK(now.player().steps() == 60);
  CHECK(scene_file_of(now).runs == runs);
  CHECK(scene_file_of(now).typed == typed);
}
