// The graph of the effects: its edges agree with the order, and what each effect did agrees with the counts.
#include "scene/graph.hpp"

#include <algorithm>

#include "core/scene/declared.hpp"
#include "scene/schedule.hpp"

using namespace snug;
using namespace snug::test;

namespace {

std::vector<const scene::EffectKind*> kinds_of(const std::vector<EffectCall>& calls) {
  const auto planned = scene::plan(calls, scene::catalogue());
  REQUIRE(planned.has_value());
  std::vector<const scene::EffectKind*> kinds;
  for (const scene::Planned& one : *planned) kinds.push_back(one.kind);
  return kinds;
}

const scene::Rail& rail(const std::vector<scene::Rail>& rails, scene::Slot slot) {
  const auto found = std::find_if(rails.begin(), rails.end(), [&](const scene::Rail& one) { return one.slot == slot; });
  REQUIRE(found != rails.end());
  return *found;
}

std::vector<EffectCall> all_of_a_pile() {
  std::vector<EffectCall> calls = solid(0.2);
  for (const char* effect : {"trail", "shadow", "cull"}) calls.push_back(call(effect));
  return calls;
}

}  // namespace

TEST_CASE("each edge of the graph goes down, from who writes to who reads; only what the last frame left goes up") {
  const auto kinds = kinds_of(all_of_a_pile());  // fall bounce move refit broad_phase narrow_phase cull shadow trail
  REQUIRE(kinds.size() == 9);
  const auto rails = scene::rails_of(kinds);
  using scene::Slot;
  CHECK(rail(rails, Slot::kTime).writers.empty());
  CHECK(rail(rails, Slot::kTime).readers == std::vector<int>{0, 2});
  CHECK(rail(rails, Slot::kVelocities).writers == std::vector<int>{0, 1});
  CHECK(rail(rails, Slot::kVelocities).readers == std::vector<int>{1, 2});
  CHECK(rail(rails, Slot::kPoses).writers == std::vector<int>{1, 2});
  CHECK(rail(rails, Slot::kPoses).readers == std::vector<int>{3, 5, 7, 8});
  CHECK(rail(rails, Slot::kContacts).writers == std::vector<int>{5});
  CHECK(rail(rails, Slot::kContacts).late == std::vector<int>{1});
  CHECK(rail(rails, Slot::kContacts).first() == 1);
  CHECK(rail(rails, Slot::kTrails).readers.empty());
  for (const scene::Rail& one : rails)
    for (const int reader : one.readers)
      for (const int writer : one.writers) CHECK((writer <= reader || scene::has(kinds[reader]->revises, one.slot)));
  for (std::size_t i = 1; i < rails.size(); ++i) CHECK(rails[i - 1].begin() <= rails[i].begin());
}

TEST_CASE("what an effect did in each frame adds up to its counts, and what was new is the reason") {
  Scene scene = opened({.bodies = {floor(), box({0.5, 0.25, 0.4}, {0, 0.4, 0})}, .effects = all_of_a_pile()});
  std::vector<std::int64_t> run(scene.tallies().size(), 0), skipped = run;
  for (int frame = 0; frame < 200; ++frame) {
    scene.step();
    scene::SlotSet changed = 0;
    for (std::size_t i = 0; i < run.size(); ++i) {
      const scene::Deed& deed = scene.deeds()[i];
      const bool ran = deed.kind == scene::Deed::Kind::kRan;
      ++(ran ? run[i] : skipped[i]);
      CHECK(deed.first == (frame == 0));
      CHECK(ran == (deed.news != 0));
      if (ran) changed |= scene.kinds()[i]->writes | scene.kinds()[i]->revises;
    }
    CHECK((scene.changes() & ~changed) == 0);  // nothing changes but by an effect that runs
    CHECK((scene.changes() != 0) == scene.changed());
  }
  CHECK(scene.resting());
  for (std::size_t i = 0; i < run.size(); ++i) {
    CHECK(run[i] == scene.tallies()[i].run);
    CHECK(skipped[i] == scene.tallies()[i].skipped);
    CHECK(scene.deeds()[i].kind == scene::Deed::Kind::kSkipped);
  }
}

TEST_CASE("a push wakes the island of the body, and no other") {
  Declaration two_piles{.bodies = {floor()}, .effects = solid(0.1)};
  for (const double x : {-3.0, 3.0})
    for (const double y : {0.26, 0.78}) two_piles.bodies.push_back(box({0.5, 0.25, 0.4}, {x, y, 0}));
  Scene scene = opened(two_piles);
  while (!scene.resting()) {
    REQUIRE(scene.frame() < 400);
    scene.step();
  }
  const int rest = scene.frame();
  const V3 left = motion(scene, 2).position, top = motion(scene, 4).position;
  CHECK_FALSE(scene.push(0));  // the floor is fixed
  REQUIRE(scene.push(3));      // the lower box of the right pile
  CHECK_FALSE(scene.resting());
  const auto before = tally(scene, "fall").run;
  double highest = 0;
  for (int frame = 0; frame < 5; ++frame) {
    scene.step();
    CHECK(motion(scene, 1).asleep);
    CHECK(motion(scene, 2).asleep);
    CHECK_FALSE(motion(scene, 3).asleep);
    CHECK_FALSE(motion(scene, 4).asleep);
    highest = std::max(highest, motion(scene, 4).position[1]);
  }
  CHECK(tally(scene, "fall").run == before + 5);
  CHECK(highest > top[1]);  // what lies on it is lifted
  CHECK(motion(scene, 2).position == left);
  while (!scene.resting()) {
    REQUIRE(scene.frame() < rest + 400);
    scene.step();
  }
  const int later = scene.frame();
  const auto hash = scene.world().hash();
  scene.go(rest - 10);
  scene.go(later);
  CHECK(scene.world().hash() == hash);  // it is remembered
  scene.go(rest - 10);
  REQUIRE(scene.push(1));  // forgets the later one
  scene.go(later);
  CHECK(scene.world().hash() != hash);
}

TEST_CASE("a push without an effect that moves bodies is refused") {
  Scene scene = opened({.bodies = {box({0.5, 0.25, 0.4}, {0, 0.4, 0})}, .effects = {call("refit")}});
  scene.step();
  CHECK_FALSE(scene.push(0));
}
