// What a step is about is drawn large, in every lesson. (Boxes and their axes: subjects/pair/stage.test.cpp.)
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lone_stage.hpp"
#include "viewed_lessons.hpp"

namespace snug::app {
namespace {

struct StageSize {
  std::string name;
  ImVec2 stage;
  float card;  // of a question; 0: none is asked
  Theme theme = Theme::kLight;
};
const StageSize kStages[]{{"laptop", {628, 566}, 0},
                          {"laptop, asked", {628, 566}, 188},
                          {"large", {1162, 846}, 0},
                          {"presentation", {999, 664}, 0, Theme::kProjector},
                          {"presentation, asked", {999, 664}, 170, Theme::kProjector},
                          {"phone", {390, 390}, 0}};

constexpr float kLarge = 0.6f;  // of the free stage's smaller side

/// A lesson with steps at which less is drawn, for a good reason.
struct Smaller {
  float least;  // at any step
  std::string why;
  float once = kLarge;  // at some step of each run
};
const std::string kToCome = "the camera stands still while volumes come that are larger than the points",
                  kWords = "the words at the axis and its ends need room beside the boxes",
                  kMotion = "the way of what moves stays in view";
const std::map<std::string_view, Smaller> kSmaller{
    {"box-claims", {0.46f, kToCome}},     {"bvh-build", {0.43f, kToCome}},
    {"kdop-space", {0.59f, kToCome}},     {"kdop-update", {0.58f, kToCome}},
    {"obb-fitting", {0.57f, kToCome}},    {"rounding-sphere", {0.51f, kToCome}},
    {"scene-updates", {0.21f, kToCome}},  {"sphere-brute-force", {0.49f, kToCome}},
    {"swept-fit", {0.42f, kToCome}},      {"epsilons", {0.59f, kWords}},
    {"obb-axes", {0.53f, kWords, 0.57f}}, {"vanishing-axes", {0.57f, kWords}},
    {"scene-effects", {0.42f, kMotion}},  {"welzl-recursion", {0.52f, "the tree of calls stands beside the points"}},
};

/// The bodies of a scene that move: its floor is large anyway.
Around moving_bodies(LoneStage& stage) {
  const lesson::SceneFrame& frame = *lesson::frame_of(stage.session());
  const auto members = lesson::members_of(stage.session());
  Around around;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].fixed) continue;
    for (const Point3& corner : members[i].shape.corners) {
      const Point3 place = frame.bodies[i].position + frame.bodies[i].rotation() * corner;
      const ScreenPoint at = stage.camera().project(place);
      const auto radius = static_cast<float>(members[i].shape.radius * stage.camera().scale_at(place));
      around.take({at.x - radius, at.y - radius}), around.take({at.x + radius, at.y + radius});
    }
  }
  return around;
}

/// The share of the free stage's smaller side that the step takes.
float share_of(LoneStage& stage, const StageSize& size) {
  Around around = stage.drawn();
  const lesson::Session& session = stage.session();
  if (session.lesson().subject->name == std::string_view("scene") && lesson::set_of(session).at_points())
    around = moving_bodies(stage);
  const float scale = palette_of(size.theme).text;
  return around.longer() / free_side(size.stage, size.card, stage.second_picture(), scale);
}

/// Calls see at some steps of each run of a lesson, or at its questions.
template <class See>
void walk(lesson::Session& session, bool asked, See see) {
  for (const std::string_view situation : lesson::situation_names(session.lesson())) {
    if (!session.stage().show_situation(situation)) continue;
    for (const std::string& algorithm : session.lesson().algorithms) {
      if (!session.player().choose(0, algorithm)) continue;
      const std::string run = std::string(situation) + ", " + algorithm;
      const int stride = std::max(1, session.player().steps() / 8);
      for (int step = 0; !asked && step <= session.player().steps(); step += stride) session.jump(step), see(run);
      if (!asked) continue;
      for (session.go(0);
           session.player().step() < session.player().steps() || session.conversation().asked() != nullptr;) {
        if (session.conversation().asked() == nullptr) {
          session.forward();
          continue;
        }
        see(run + ", asked " + session.conversation().asked()->question->id);
        if (session.conversation().asked()->step == lesson::Asked::kAnytime) break;  // about what is measured
        REQUIRE(session.conversation().give(
            lesson::model_answer(*session.conversation().asked(), session.player().run(0))));
        session.conversation().acknowledge();
      }
    }
  }
}

}  // namespace

TEST_CASE("at each step what it is about takes three fifths of the free stage's smaller side, and beside a question") {
  Bench bench(test::flat_kdop());
  int seen = 0;
  for (const lesson::Lesson& lesson : all_lessons()) {
    if (subject_of(lesson).cover != nullptr) continue;  // a chart has the whole stage
    CAPTURE(lesson.id);
    const auto named = kSmaller.find(lesson.id);
    const Smaller bound = named != kSmaller.end() ? named->second : Smaller{kLarge, "it is none"};
    CAPTURE(bound.why);
    float smallest = 1;
    for (const StageSize& size : kStages) {
      CAPTURE(size.name);
      bench.app.settings().theme = size.theme;
      bench.frames(1);
      lesson::Lesson copy = lesson;
      if (size.card == 0) copy.questions.clear();
      LoneStage stage(bench, std::move(copy), size.stage, size.card);
      std::map<std::string, float> largest;  // of each run
      walk(stage.session(), size.card > 0, [&](const std::string& run) {
        CAPTURE(run);
        CAPTURE(stage.session().player().step());
        const float share = share_of(stage, size);
        CHECK(share >= bound.least);
        smallest = std::min(smallest, share);
        largest[run] = std::max(largest[run], share);
        ++seen;
      });
      for (const auto& [run, share] : largest)
        if (size.card == 0) CHECK_MESSAGE(share >= bound.once, run);
    }
    if (named != kSmaller.end()) CHECK_MESSAGE(smallest < kLarge, "it needs no bound of its own any more");
  }
  CHECK(seen > 10'000);
}

}  // namespace snug::app
