// What a step is about is drawn large, in every lesson. (Boxes and their axes: subjects/pair/stage.test.cpp.)
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "app/cover.hpp"
#include "bench.hpp"
#include "course_lessons.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

struct Free {
  const char* name;
  ImVec2 stage;
  float card;
};
constexpr Free kStages[]{{"laptop", {628, 566}, 0},
                         {"laptop, card", {628, 566}, 150},
                         {"large", {1162, 846}, 0},
                         {"presentation", {999, 664}, 0},
                         {"phone", {390, 390}, 0}};

/// The longer side of what stands on the stage, by its handles.
float extent_of(const std::vector<Handle>& handles) {
  ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
  for (const Handle& one : handles) {
    low = {std::min(low.x, one.x), std::min(low.y, one.y)};
    high = {std::max(high.x, one.x), std::max(high.y, one.y)};
  }
  return handles.empty() ? 0 : std::max(high.x - low.x, high.y - low.y);
}

}  // namespace

TEST_CASE("at each step the handles take a sixth of the free stage's smaller side, whatever their volumes take") {
  constexpr float kTools = 52, kAround = 28, kSentence = 92, kLeast = 0.18f;
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(lessons_folder())) {
    if (entry.path().extension() != ".toml" || entry.path().filename() == "course.toml") continue;
    const std::string id = entry.path().stem().string();
    if (!course_lesson(id, false).points.mesh.empty()) continue;
    for (const Free& one : kStages) {
      Bench bench(course_lesson(id, false), {.stage = {0, 0, one.stage.x, one.stage.y},
                                             .timeline = {0, one.stage.y, one.stage.x, 140},
                                             .foot = one.card});
      const std::string_view subject = bench.session().lesson().subject->name;
      if (bench.app.cover() != nullptr || subject == "scene" || subject == "update")
        continue;  // their bodies are not held
      for (const std::string_view situation : lesson::situation_names(bench.session().lesson())) {
        if (!bench.session().show_situation(situation)) continue;
        const int steps = bench.session().steps(), stride = std::max(1, steps / 8);
        for (int step = 0; step <= steps; step += stride) {
          bench.session().jump(step);
          bench.frames(6);
          const bool wide = one.stage.x >= 560;
          const float free = std::min(one.stage.x - 2 * kAround,
                                      one.stage.y - kTools - std::max(wide ? kSentence : kAround, one.card));
          CAPTURE(one.name);
          CAPTURE(situation);
          CAPTURE(step);
          CHECK_MESSAGE(extent_of(bench.app.handles()) >= kLeast * free, id);
          ++seen;
        }
      }
    }
  }
  CHECK(seen > 2'000);
}

}  // namespace snug::app
