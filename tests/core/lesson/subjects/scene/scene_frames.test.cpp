// The frames of a scene: those that are not kept are taken anew, to the same bits.
#include "lesson/subjects/scene/scene_frames.hpp"

#include "core/scene/declared.hpp"
#include "geometry/random.hpp"
#include "lesson/subjects/scene/searched.hpp"

using namespace snug;
using namespace snug::test;

namespace {

Declaration falling_and_turning() {
  Declaration declaration{.bodies = {floor(), named("a", box({1, 0.5, 0.25}, {9, 3, 0}))}, .effects = solid(0.4)};
  Random random(7);
  for (int i = 0; i < 8; ++i) {
    const V3 at{random.between(-0.5, 0.5), 0.6 + 0.5 * i, random.between(-0.5, 0.5)};
    declaration.bodies.push_back(i % 2 == 0 ? ball(0.25, at) : box({0.25, 0.2, 0.3}, at));
  }
  for (const char* effect : {"trail", "shadow", "projection_rays"}) declaration.effects.push_back(call(effect));
  declaration.effects.push_back(call("spin", {{"turns_per_second", {0.3}, ""}}, "a"));
  return declaration;
}

void turn_off(Scene& scene, std::string_view effect) {
  for (std::size_t i = 0; i < scene.tallies().size(); ++i)
    if (scene.tallies()[i].effect == effect) scene.turn(i, false);
}

/// 200 frames, with effects switched off on the way.
lesson::SceneFrames taken(std::size_t most) {
  lesson::SceneFrames frames(opened(falling_and_turning()), most);
  while (frames.size() <= 200) {
    if (frames.size() == 51) turn_off(frames.scene(), "spin a");
    if (frames.size() == 71) turn_off(frames.scene(), "narrow_phase");
    if (frames.size() == 81) turn_off(frames.scene(), "shadow");
    frames.step();
  }
  frames.finish();
  return frames;
}

template <class Value>
bool same(const std::vector<Value>& a, const std::vector<Value>& b, bool (*equal)(const Value&, const Value&)) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

void check_same(const lesson::SceneFrame& a, const lesson::SceneFrame& b) {
  using Placed = lesson::SceneFrame::Placed;
  using Box = Aabb<double, 3>;
  CHECK(same<Placed>(a.bodies, b.bodies, [](const Placed& x, const Placed& y) {
    return x.position == y.position && x.rotation() == y.rotation();
  }));
  CHECK(same<Box>(a.volumes, b.volumes, [](const Box& x, const Box& y) { return x.min == y.min && x.max == y.max; }));
  CHECK(a.pairs == b.pairs);
  CHECK(a.near == b.near);
  CHECK(a.touching == b.touching);
  CHECK(a.shadows == b.shadows);
  CHECK(a.trails == b.trails);
  CHECK(same<scene::Ray>(a.rays, b.rays,
                         [](const scene::Ray& x, const scene::Ray& y) { return x.from == y.from && x.to == y.to; }));
  CHECK(a.swept_along == b.swept_along);
}

}  // namespace

TEST_CASE("frames that are not kept are taken anew, to the same bits, with effects switched off where they were") {
  const lesson::SceneFrames all = taken(lesson::kMostFrameBytes), few = taken(600'000);
  REQUIRE(all.size() == 201);
  REQUIRE(few.size() == 201);
  CHECK(all.kept() == 201);
  CHECK(few.kept() < 50);
  const auto check = [&](std::size_t frame) {
    INFO("frame " << frame);
    check_same(few[frame], all[frame]);
    CHECK(few.kept() < 50);
  };
  for (std::size_t frame = 201; frame-- > 0;) check(frame);           // back, one by one
  for (std::size_t frame = 0; frame < 201; frame += 3) check(frame);  // and on
  for (const std::size_t frame : {200u, 0u, 71u, 70u, 72u, 16u, 15u, 17u, 160u, 50u, 51u, 52u, 199u, 81u, 80u, 1u})
    check(frame);
}

TEST_CASE("a run without a scene has no frames") {
  lesson::SceneFrames none;
  CHECK(none.size() == 0);
}

TEST_CASE("a search that is run again on a frame compares what the scene's search compared, with room for rounding") {
  const Declaration two{.bodies = {box({0.5, 0.5, 0.5}, {0, 0, 0}), box({0.5, 0.5, 0.5}, {1 + 2e-15, 0, 0})},
                        .effects = {call("refit"), call("broad_phase"), call("narrow_phase")}};
  for (std::size_t search = 0; search < hierarchy::kPairSearchNames.size(); ++search) {
    INFO(hierarchy::kPairSearchNames[search]);
    Declaration declaration = two;
    declaration.effects[1].settings = {{"search", {}, std::string(hierarchy::kPairSearchNames[search])}};
    lesson::SceneFrames frames(opened(declaration));
    frames.step();
    const lesson::SceneFrame& frame = frames[1];
    REQUIRE(frame.volumes[0].max[0] < frame.volumes[1].min[0]);
    const std::vector<BodyPair> pair{{0, 1}};
    CHECK(frame.pairs == pair);
    CHECK(lesson::pairs_compared(frame, static_cast<hierarchy::PairSearch>(search)) == pair);
    CHECK(frames.scene().world().state.funnel.compared == 1);
    if (frame.swept_along >= 0) CHECK(lesson::active_list(frame, 1) == std::vector<Index>{0});
  }
}
