// Lessons on scenes: the session moves through frames, answers and grades by figures that are worked out.
#include <doctest/doctest.h>

#include <cstdio>
#include <memory>

#include "lesson/play.hpp"
#include "lesson/scene_runs.hpp"
#include "lesson/session.hpp"

using namespace snug;

namespace {

lesson::Lesson read(const std::string& id) {
  const std::string path = std::string(SNUG_SOURCE_DIR) + "/lessons/" + id + ".toml";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  REQUIRE(file);
  std::string text;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) text.append(buffer, n);
  auto read = lesson::read_lesson(text, path);
  INFO((read ? "" : read.error().message()));
  REQUIRE(read.has_value());
  return *std::move(read);
}

lesson::Session opened(const std::string& id) {
  auto session = lesson::Session::open(read(id));
  REQUIRE(session.has_value());
  return *std::move(session);
}

const fit::FrameTaken& frame(const lesson::Session& session) { return *std::get_if<fit::FrameTaken>(&session.current(0)->step.fact); }

/// What effects did by frame n: effect, constructed, run, skipped.
std::vector<std::string> counts(const lesson::Session& session, std::size_t n) {
  std::vector<std::string> lines;
  for (const scene::Tally& tally : (*session.frames(0))[n].tallies)
    lines.push_back(tally.effect + " " + std::to_string(tally.constructed) + " " + std::to_string(tally.run) + " " + std::to_string(tally.skipped));
  return lines;
}

}  // namespace

TEST_CASE("a scene's frames are the steps of its lesson, with their figures") {
  lesson::Session session = opened("scene-broad");
  CHECK(session.steps() == 120);
  REQUIRE(session.frames(0) != nullptr);
  CHECK(session.frames(0)->size() == 121);
  session.jump(30);
  CHECK(frame(session).frame == 30);
  CHECK(frame(session).all_pairs == 780);
  CHECK(frame(session).after_loose < frame(session).after_broad);
  CHECK(static_cast<double>((*session.frames(0))[30].pairs.size()) == frame(session).after_broad);
  const auto figures = session.figures(0);
  CHECK(figures.size() == 5);
  CHECK(figures[0].value == 30);
  session.back();
  CHECK(frame(session).frame == 29);
}

TEST_CASE("each lesson's effects run as often as their inputs change") {
  CHECK(counts(opened("scene-broad"), 120) ==
        std::vector<std::string>{"spin 1 120 0", "orbit 1 120 0", "refit 1 120 0", "broad_phase 1 120 0", "narrow_phase 1 120 0"});
  CHECK(counts(opened("scene-updates"), 120) == std::vector<std::string>{"spin body 1 120 0", "refit 1 120 0"});
}

TEST_CASE("what the student chooses is what the scene runs") {
  lesson::Session session = opened("scene-updates");
  const auto at = [&](const char* method) {
    REQUIRE(session.choose(0, method).has_value());
    session.jump(session.steps() / 3);
    return frame(session);
  };
  const fit::FrameTaken rebuilt = at("rebuild"), climbed = at("hill_climb"), loose = at("loose"), ball = at("sphere");
  CHECK(rebuilt.cost == 80);
  CHECK(rebuilt.slack == 0);
  CHECK(climbed.cost > 0);
  CHECK(loose.cost == 0);
  CHECK(loose.slack > 1);
  CHECK(ball.slack < 1e-9);
  CHECK(std::holds_alternative<fit::Sphere3>(session.current(0)->step.volume));
  CHECK(rebuilt.hash_low == loose.hash_low);  // the motion is the same
}

TEST_CASE("moving a body makes the scene anew, and undo brings the old one back") {
  lesson::Session session = opened("scene-broad");
  const std::uint64_t before = session.trace_hash();
  REQUIRE(session.move(0, {5, 5, 5}).has_value());
  CHECK(session.trace_hash() != before);
  session.undo();
  CHECK(session.trace_hash() == before);
}

TEST_CASE("questions on figures have the range that holds them as their answer") {
  for (const char* id : {"scene-broad", "scene-updates"}) {
    lesson::Session session = opened(id);
    const auto played = lesson::play(session);
    REQUIRE(played.has_value());
    CHECK(played->sound());
    CHECK(played->not_asked.empty());
    REQUIRE(played->grade.has_value());
    CHECK(played->grade->done);
  }
  lesson::Session session = opened("scene-broad");
  session.forward();
  const lesson::Asked* asked = session.asked();
  REQUIRE(asked != nullptr);
  REQUIRE(asked->choices.size() == 4);
  CHECK(asked->choices[0] == "at most 20 pairs");
  CHECK(asked->choices[3] == "more than 400 pairs");
  session.answer({lesson::Answer::Kind::kChoice, 3});
  REQUIRE(session.outcome() != nullptr);
  CHECK_FALSE(session.outcome()->right);
  CHECK(session.step() == 1);
}

TEST_CASE("a task on a scene is graded by its last frame") {
  lesson::Session session = opened("scene-broad");
  session.start_task();
  REQUIRE(session.grade().has_value());
  CHECK_FALSE(session.grade()->done);
  CHECK(session.grade()->says.find("at least 4 pairs is asked for") != std::string::npos);
}
