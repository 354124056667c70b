// Lessons on scenes: the session moves through frames, answers and grades by figures that are worked out.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"
#include "lesson/subjects/scene/still_scene.hpp"

using namespace snug;

namespace {

lesson::Session opened_lesson(const std::string& id, scene::Clock clock = nullptr) {
  auto session = lesson::Session::open(test::lesson_of(id), {}, clock);
  REQUIRE(session.has_value());
  return *std::move(session);
}

const lesson::FrameStep& step(const lesson::Session& session) {
  return lesson::scene_run(session.player().run(0)).trace()[session.player().step() - 1].step;
}

const lesson::FrameTaken& frame(const lesson::Session& session) {
  return *std::get_if<lesson::FrameTaken>(&step(session).fact);
}

/// Loads so many bodies, one on the other; what is said if they are refused.
std::string load_pile(int bodies) {
  lesson::Session session = opened_lesson("scene-effects");
  io::PointFile pile{.dim = 3};
  for (int i = 0; i < bodies; ++i) pile.points.emplace_back(0.1 * i, 1 + 0.1 * i, 0);
  const auto loaded = session.stage().load(pile, "pile.xyz");
  return loaded ? "" : loaded.error().what;
}

/// What effects did by frame n: effect, constructed, run, skipped.
std::vector<std::string> counts(const lesson::Session& session, std::size_t n) {
  std::vector<std::string> lines;
  const lesson::SceneRecording& run = *recorded_scene(session, 0);
  for (std::size_t i = 0; i < run.tallies.size(); ++i) {
    const lesson::EffectCount& count = run.counts[n * run.tallies.size() + i];
    lines.push_back(run.tallies[i].effect + " " + std::to_string(run.tallies[i].constructed) + " " +
                    std::to_string(count.run) + " " + std::to_string(count.skipped));
  }
  return lines;
}

/// What a run of an effect takes.
std::string time_of(const lesson::Session& session, std::string_view effect) {
  for (const lesson::Switch& one : session.player().switches())
    if (one.name == effect) return one.microseconds;
  return {};
}

/// Each reading is 3 µs after the last one; the coarse clock tells of every 100 µs.
double readings = 0;
double fine() { return readings += 3000; }
double coarse() { return 1e5 * std::floor(fine() / 1e5); }

}  // namespace

TEST_CASE("a scene takes no more points than it shows within seconds, and says how many these are") {
  const std::string refused = load_pile(300);
  CHECK(refused.starts_with("this scene can show at most "));
  CHECK(refused.find(" points, and here are 300: ") != std::string::npos);
  CHECK(load_pile(20).empty());
  lesson::Session session = opened_lesson("scene-effects");
  const lesson::Done made = session.stage().set_generator("sphere", 2000, 3, 3);
  REQUIRE_FALSE(made.has_value());
  CHECK(made.error().what.starts_with("this scene can show at most "));
}

TEST_CASE("effects are timed by the clock that is passed in, and no trace knows of it") {
  const lesson::Session untimed = opened_lesson("scene-updates"), timed = opened_lesson("scene-updates", fine),
                        barely = opened_lesson("scene-updates", coarse);
  CHECK(time_of(untimed, "refit").empty());
  CHECK(time_of(timed, "refit") == "3.0");
  CHECK(time_of(timed, "spin body") == "3.0");
  CHECK(time_of(timed, "bounce").empty());
  CHECK(time_of(barely, "refit") == "< 20");  // 200 µs / sqrt(120)
  CHECK(timed.player().trace_hash() == untimed.player().trace_hash());
  CHECK(barely.player().trace_hash() == untimed.player().trace_hash());
  lesson::Session off = opened_lesson("scene-updates", fine);
  off.jump(20);
  REQUIRE(off.player().toggle({.name = "spin body"}));
  CHECK(time_of(off, "spin body") == "3.0");
}

TEST_CASE("an effect's time is told as finely as its clock can tell it") {
  const auto told = [](double microseconds, std::int64_t runs, double step) {
    return lesson::effect_time_text({.run = runs, .nanoseconds = 1000 * microseconds * static_cast<double>(runs)},
                                    step);
  };
  CHECK(told(12.34, 100, 30) == "12");
  CHECK(told(1.26, 100, 30) == "1.3");
  CHECK(told(0.054, 100, 30) == "0.05");
  CHECK(told(0, 100, 5000) == "< 1");
  CHECK(told(0.9, 100, 5000) == "< 1");
  CHECK(told(1.1, 100, 5000) == "1.1");
  CHECK(told(15, 60, 100'000) == "< 30");
  CHECK(told(0, 0, 30).empty());
}

TEST_CASE("a scene's frames are the steps of its lesson, with their figures") {
  lesson::Session session = opened_lesson("scene-broad");
  CHECK(session.player().steps() == 120);
  REQUIRE(recorded_scene(session, 0) != nullptr);
  CHECK(recorded_scene(session, 0)->frames.size() == 121);
  session.jump(30);
  CHECK(frame(session).frame == 30);
  CHECK(frame(session).all_pairs == 780);
  CHECK(frame(session).after_loose < frame(session).after_broad);
  CHECK(static_cast<double>(recorded_scene(session, 0)->frames[30].pairs.size()) == frame(session).after_broad);
  const auto figures = session.telling().figures(0);
  CHECK(figures.size() == 7);
  CHECK(figures[0].value == 30);
  session.go(session.player().step() - 1);
  CHECK(frame(session).frame == 29);
}

TEST_CASE("each lesson's effects run as often as their inputs change") {
  CHECK(counts(opened_lesson("scene-broad"), 120) == std::vector<std::string>{"spin 1 120 0", "orbit 1 120 0",
                                                                              "refit 1 120 0", "broad_phase 1 120 0",
                                                                              "narrow_phase 1 120 0"});
  CHECK(counts(opened_lesson("scene-updates"), 120) == std::vector<std::string>{"spin body 1 120 0", "refit 1 120 0"});
}

TEST_CASE("a figure is not told before the first question about it is answered") {
  lesson::Session session = opened_lesson("scene-broad");
  const auto told = [&](std::string_view key) {
    for (const lesson::Figure& figure : session.telling().figures(0))
      if (figure.key == key) return figure.known;
    return false;
  };
  session.go(0);
  session.conversation().give(lesson::OneChoice{0});
  CHECK(session.player().step() == 1);
  CHECK(told("after_broad"));
  CHECK_FALSE(told("after_loose"));
  CHECK_FALSE(told("touching"));
  session.jump(29);
  session.conversation().give(lesson::OneChoice{0});
  session.jump(40);
  CHECK(told("after_loose"));
  CHECK_FALSE(told("touching"));
  session.jump(60);
  CHECK(told("touching"));  // the frame that it is about
}

TEST_CASE("the result of a method that is not on the stage is what its own run ends with") {
  for (const char* id : {"kdop-update", "scene-broad"}) {
    const lesson::Session beside = opened_lesson(id);
    lesson::Session session = opened_lesson(id);
    for (const std::string& algorithm : session.lesson().algorithms) {
      CAPTURE(algorithm);
      REQUIRE(session.player().choose(0, algorithm).has_value());
      session.jump(session.player().steps());
      const auto& result = beside.player().result(*lesson::find_method(session.lesson(), algorithm));
      const auto own = session.stage().subject().figures(session.player().view());
      REQUIRE(result.size() == own.size());
      for (std::size_t i = 0; i < own.size(); ++i) {
        CHECK(result[i].key == own[i].key);
        CHECK(result[i].text == own[i].text);
      }
    }
  }
}

TEST_CASE("while a body is dragged, no frame is worked out that is not shown") {
  for (const std::string id : {"scene-broad", "scene-effects", "kdop-update"}) {
    CAPTURE(id);
    lesson::Session session = opened_lesson(id);
    session.jump(0);
    const int frames = session.player().steps();
    const auto recorded = [&] { return lesson::scene_run(session.player().run(0)).recorded(); };
    session.stage().begin_drag();
    for (int i = 1; i <= 3; ++i) {
      REQUIRE(session.stage().move(0, session.stage().subject().at(0) + Vector<double, 3>(0.1, 0, 0)).has_value());
      CHECK(frame_of(session) != nullptr);
      static_cast<void>(session.player().switches());
      static_cast<void>(session.telling().figures());
      for (std::size_t task = 0; task < session.lesson().tasks.size(); ++task) static_cast<void>(session.grade(task));
      CHECK(recorded() == 0);
      CHECK(session.player().steps() == frames);
    }
    session.stage().end_drag();
    const std::uint64_t dragged = session.player().trace_hash();
    CHECK(recorded() == frames);
    session.stage().undo();
    session.stage().redo();
    CHECK(session.player().trace_hash() == dragged);
  }
}

TEST_CASE("a task's grade waits until the hand rests, and is then that of what it left") {
  lesson::Session session = opened_lesson("scene-broad");
  session.stage().start_task(0);
  const std::string before = session.grade(0).says;
  session.stage().begin_drag();
  REQUIRE(session.stage()
              .move(0, session.stage().subject().at(1) + Vector<double, 3>(0.01, 0, 0))
              .has_value());  // both overlap now
  CHECK(session.grade(0).says == before);
  session.stage().end_drag();
  CHECK(session.grade(0).says != before);
}

TEST_CASE("while a body is dragged, the results of methods wait until it rests") {
  lesson::Session session = opened_lesson("kdop-update");
  session.jump(0);
  const lesson::Method& other = *lesson::find_method(session.lesson(), "sphere");
  session.stage().begin_drag();
  REQUIRE(session.stage().move(0, session.stage().subject().at(0) + Vector<double, 3>(0.1, 0, 0)).has_value());
  CHECK(session.player().result(other).empty());
  CHECK(session.player().result(*session.player().method(0)).empty());
  session.stage().end_drag();
  CHECK_FALSE(session.player().result(other).empty());
  CHECK_FALSE(session.player().result(*session.player().method(0)).empty());
}

TEST_CASE("no frame of a scene is marked, but for questions") {
  for (const std::string id : {"scene-broad", "scene-updates"})
    for (const lesson::Session session = opened_lesson(id); const lesson::Mark& mark : session.player().marks())
      CHECK(mark.kind == lesson::Mark::Kind::kQuestion);
}

TEST_CASE("a lesson that declares no scene constructs no effect and draws one frame") {
  for (const std::string id : {"sphere-ritter", "obb-axes", "obb-sat", "frustum-2d", "frustum-3d"}) {
    CAPTURE(id);
    const lesson::Lesson own = test::lesson_of(id);
    auto scene = scene::Scene::open(lesson::still_scene(lesson::Session::open(own)->stage().subject()));
    REQUIRE(scene.has_value());
    CHECK(scene->tallies().empty());
    CHECK(scene->world().size() == (own.tables != nullptr ? 2u : 1u));
    for (int i = 0; i < 60; ++i) {
      scene->step();
      CHECK_FALSE(scene->changed());
    }
    CHECK(scene->resting());
  }
}

TEST_CASE("what the student chooses is what the scene runs") {
  lesson::Session session = opened_lesson("scene-updates");
  const auto at = [&](const char* method) {
    REQUIRE(session.player().choose(0, method).has_value());
    session.jump(session.player().steps() / 3);
    return frame(session);
  };
  const lesson::FrameTaken rebuilt = at("rebuild"), climbed = at("hill_climb"), loose = at("loose"),
                           ball = at("sphere");
  CHECK(rebuilt.cost == 80);
  CHECK(rebuilt.slack == 0);
  CHECK(climbed.cost > 0);
  CHECK(loose.cost == 0);
  CHECK(loose.slack > 1);
  CHECK(ball.slack < 1e-9);
  CHECK(std::holds_alternative<fit::Sphere3>(step(session).volume));
  CHECK(rebuilt.hash_low == loose.hash_low);  // the motion is the same
}

TEST_CASE("volumes of different kinds are compared by the hull, which is one yardstick for all of them") {
  lesson::Session session = opened_lesson("scene-updates");
  const auto at = [&](const char* method) {
    REQUIRE(session.player().choose(0, method).has_value());
    session.jump(40);
    const auto figures = session.telling().figures(0);
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [](const lesson::Figure& figure) { return figure.key == lesson::kOverHull; });
    REQUIRE(found != figures.end());
    CHECK(found->text == lesson::number_text(found->value) + " times");
    const double own = fit::measure_of(step(session).volume, 3);
    const fit::Result hull = fit::find_algorithm("hull", "quickhull")->fit(*session.stage().subject().points(), {});
    CHECK(found->value == doctest::Approx(own / fit::measure_of(hull.volume, 3)).epsilon(1e-9));
    return found->value;
  };
  const double ball = at("sphere"), oriented = at("obb"), tight = at("rebuild"), rotated = at("rotated_box"),
               loose = at("loose");
  CHECK(oriented > 1);
  CHECK(oriented < tight);
  CHECK(tight < rotated);
  CHECK(rotated < loose);
  CHECK(oriented < ball);
}

TEST_CASE("a figure's ranges are written as people write them") {
  const auto texts = [](std::string_view figure, std::vector<double> bounds) {
    return lesson::range_texts(bounds, lesson::scene_figure(figure, 0).unit);
  };
  using Texts = std::vector<std::string>;
  CHECK(texts("cost", {0, 8, 79}) == Texts{"none", "1 to 8 points", "9 to 79 points", "more than 79 points"});
  CHECK(texts("touching", {0, 1, 60}) == Texts{"none", "1 pair", "2 to 60 pairs", "more than 60 pairs"});
  CHECK(texts("slack", {10, 1000}) == Texts{"at most 10 %", "10 to 1,000 %", "more than 1,000 %"});
  CHECK(texts("over_hull", {1.2, 2}) == Texts{"at most 1.2 times", "1.2 to 2 times", "more than 2 times"});
  CHECK(texts("energy", {1, 2}).at(1) == "1 to 2 kg units²/s²");
  CHECK(lesson::scene_figure_text("energy", -74.25) == lesson::number_text(-74.25) + " kg units²/s²");
  CHECK(lesson::scene_figure_text("slack", 384.67) == "+385 %");
  CHECK(lesson::scene_figure_text("slack", 0) == "0.0 %");
  CHECK(lesson::looser_words(0.35, "the tightest") == "35.0 % larger than the tightest");
  CHECK(lesson::looser_words(3.8467, "the tightest") == "4.8 times the tightest (+385 %)");
}

TEST_CASE("moving a body makes the scene anew, and undo brings the old one back") {
  lesson::Session session = opened_lesson("scene-broad");
  const std::uint64_t before = session.player().trace_hash();
  REQUIRE(session.stage().move(0, {5, 5, 5}).has_value());
  CHECK(session.player().trace_hash() != before);
  session.stage().undo();
  CHECK(session.player().trace_hash() == before);
}

TEST_CASE("questions on figures have the range that holds them as their answer") {
  for (const char* id : {"scene-broad", "scene-updates"}) {
    lesson::Session session = opened_lesson(id);
    const auto played = check::play(session);
    REQUIRE(played.has_value());
    CHECK(played->sound());
    CHECK(played->not_asked.empty());
    REQUIRE(!played->grades.empty());
    for (const lesson::Grade& grade : played->grades) CHECK(grade.done);
  }
  lesson::Session session = opened_lesson("scene-broad");
  session.forward();
  const lesson::Asked* asked = session.conversation().asked();
  REQUIRE(asked != nullptr);
  REQUIRE(asked->choices.size() == 4);
  CHECK(asked->choices[0] == "at most 20 pairs");
  CHECK(asked->choices[1] == "21 to 120 pairs");
  CHECK(asked->choices[3] == "more than 400 pairs");
  session.conversation().give(lesson::OneChoice{3});
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.player().step() == 1);
}

TEST_CASE("a question may stand long before its frame, and its figure is not told beside it") {
  lesson::Session session = opened_lesson("scene-updates");
  std::vector<std::pair<int, int>> stood;  // where each stands, and where it is decided
  for (const lesson::Asked& asked : session.conversation().questions()) stood.emplace_back(asked.step, asked.until);
  CHECK(stood == std::vector<std::pair<int, int>>{{1, 20}, {39, 40}, {90, 120}});
  session.jump(90);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.telling().asked_figure() == "slack");
  const auto told = [&](std::string_view key) {
    for (const lesson::Figure& figure : session.telling().figures(0))
      if (figure.key == key) return figure.known;
    return false;
  };
  CHECK_FALSE(told("slack"));
  CHECK(told("cost"));
  session.conversation().give(lesson::OneChoice{0});
  REQUIRE(session.conversation().outcome() != nullptr);
  CHECK(session.conversation().outcome()->right);  // the first box again
  CHECK(session.player().step() == 120);
  CHECK(told("slack"));
  CHECK(session.telling().asked_figure().empty());
}

namespace {

/// scene-updates, whose body is a mesh; more: effects after its own.
std::string with_mesh(const std::string& more, const std::string& points = "mesh = \"bunny\"") {
  std::string text = test::lessons_file("scene-updates.toml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  };
  replace("generate = \"stick\"\ncount = 80", points);
  replace("shape = \"points\"", "shape = \"mesh\"");
  text.erase(text.find("[[question]]"));
  replace("effect = \"refit\"\n", "effect = \"refit\"\n" + more);
  return text;
}

tl::expected<lesson::Session, InputError> opened_with_mesh(const std::string& more) {
  auto lesson = check::checked_lesson(with_mesh(more), "meshy.toml");
  REQUIRE(lesson.has_value());
  const std::vector<Vector<double, 3>> corners{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  return lesson::Session::open(*std::move(lesson),
                               io::PointFile{3, corners, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
}

std::string effect_called(const std::string& name) { return "\n[[scene.effect]]\neffect = \"" + name + "\"\n"; }

}  // namespace

TEST_CASE("a mesh is a body for every effect but impulses, which refuse it with their line") {
  auto session = opened_with_mesh(effect_called("broad_phase") + effect_called("narrow_phase") + effect_called("cull") +
                                  effect_called("shadow") + effect_called("trail") + effect_called("projection_rays"));
  REQUIRE(session.has_value());
  CHECK(recorded_scene(*session, 0)->frames.size() == 121);
  CHECK(session->stage().subject().with_points()->triangles().size() == 4);
  CHECK(lesson::members_of(*session)[0].shape.corners.size() == 4);
  session->jump(30);
  CHECK(frame(*session).slack > 0);
  CHECK(counts(*session, 30).size() == 8);
  for (const std::string& line : counts(*session, 30)) CHECK(line.ends_with(" 1 30 0"));

  const std::string solid = effect_called("broad_phase") + effect_called("narrow_phase") + effect_called("bounce");
  const auto refused = opened_with_mesh(solid);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().what == "bounce: has impulses for spheres and boxes alone; give body such a shape");
  const std::string text = with_mesh(solid), before = text.substr(0, text.find("\"bounce\""));
  CHECK(refused.error().position ==
        std::count(before.begin(), before.end(), '\n'));  // of the table's head, the line above

  const auto nameless = check::checked_lesson(with_mesh("", "generate = \"stick\"\ncount = 80"), "nameless.toml");
  REQUIRE_FALSE(nameless.has_value());
  CHECK(nameless.error().what.find("is a mesh, and [points] names none") != std::string::npos);
}

TEST_CASE("of a scene on a mesh no mistake hides another") {
  const std::string two = effect_called("shadow") + "glue = 2\n" + effect_called("trail") + "length = 2.5\n";
  auto lesson = check::checked_lesson(with_mesh(two), "meshy.toml");
  REQUIRE(lesson.has_value());
  const io::PointFile mesh{
      3, {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const std::vector<InputError> faults = lesson->subject->faults(*lesson, mesh);
  CHECK(faults.size() == 2);
  for (const InputError& fault : faults) CHECK(fault.position > 0);
}

TEST_CASE("a task on a scene is graded by its last frame") {
  lesson::Session session = opened_lesson("scene-broad");
  session.stage().start_task(1);
  REQUIRE(session.grade().has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->says.find("it must be at least 3 pairs") != std::string::npos);
  CHECK(session.grade()->says.find("frame 1") == std::string::npos);
  session.go(5);
  CHECK(session.grade()->says.find(" Bodies can only be moved before frame 1.") != std::string::npos);
}
