// The same scene, the same bits: run twice, gone back to, and everywhere.
#include "core/scene/declared.hpp"
#include "geometry/random.hpp"

using namespace snug;
using namespace snug::test;

namespace {

Declaration bouncing(int count, std::uint64_t seed) {
  Declaration declaration{.bodies = {floor()}, .effects = solid(0.4), .seed = seed};
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const V3 at{random.between(-1, 1), 0.6 + 0.5 * i,
                random.between(-1, 1)};  // in braces and one by one: in that order, whatever the compiler
    Body body = i % 2 == 0 ? ball(0.25, at) : box({0.25, 0.2, 0.3}, at);
    const V3 velocity{random.normal(), 0, random.normal()};
    const V3 angular_velocity{random.normal(), random.normal(), random.normal()};
    declaration.bodies.push_back(moving(body, velocity, angular_velocity));
  }
  declaration.effects.push_back(call("trail"));
  declaration.effects.push_back(call("shadow"));
  return declaration;
}

}  // namespace

TEST_CASE("the same declaration has the same bits, and another seed others") {
  Scene first = opened(bouncing(20, 3)), second = opened(bouncing(20, 3)), other = opened(bouncing(20, 4));
  first.go(300), second.go(300), other.go(300);
  CHECK(first.world().hash() == second.world().hash());
  CHECK(first.world().hash() != other.world().hash());
}

TEST_CASE("going back and on again has the bits of going on, from every frame") {
  Scene straight = opened(bouncing(12, 5)), scrubbed = opened(bouncing(12, 5));
  std::vector<std::uint64_t> hashes{straight.world().hash()};
  for (int frame = 1; frame <= 400; ++frame) straight.step(), hashes.push_back(straight.world().hash());
  scrubbed.go(400);
  for (const int frame : {399, 64, 63, 65, 0, 1, 128, 127, 200, 400, 3}) {
    scrubbed.go(frame);
    CHECK(scrubbed.frame() == frame);
    CHECK(scrubbed.world().hash() == hashes[frame]);
  }
  scrubbed.go(250), straight.go(250);
  CHECK(scrubbed.world().state.trails == straight.world().state.trails);
  CHECK(scrubbed.world().state.shadows == straight.world().state.shadows);
  CHECK(scrubbed.world().state.pairs == straight.world().state.pairs);
  CHECK(scrubbed.world().state.funnel.touching == straight.world().state.funnel.touching);
}

TEST_CASE("a long run keeps a bounded number of snapshots and still goes back to the same bits") {
  Declaration declaration{.bodies = {named("a", box({1, 2, 3}, {2, 0, 0}))},
                          .effects = {call("spin", {{"turns_per_second", {0.37}, ""}}), call("orbit"), call("refit")}};
  Scene scene = opened(declaration);
  scene.go(5000);
  const auto there = scene.world().hash();
  scene.go(20000);
  scene.go(5000);
  CHECK(scene.world().hash() == there);
}

TEST_CASE("what was set from outside has the same bits when gone back to") {
  Declaration declaration{.bodies = {floor(), named("a", ball(0.3, {3, 0.3, 0})), box({0.2, 0.2, 0.2}, {8, 6, 0})},
                          .effects = solid(0.3)};
  declaration.effects.push_back(call("drag", {{"to", {0, 0.3, 0}, ""}}, "a"));
  for (const bool pulls : {true, false})
    for (const int at : {0, 30, 64, 70, 256, 300}) {
      Scene scene = opened(declaration);
      scene.go(at);
      if (pulls) scene.pull_to({5, 0.3, 0});
      else
        for (std::size_t i = 0; i < scene.tallies().size(); ++i) scene.turn(i, scene.tallies()[i].effect != "drag a");
      std::vector<std::uint64_t> hashes;
      while (scene.frame() < at + 150) scene.step(), hashes.push_back(scene.world().hash());
      INFO("set at frame " << at << ", pulls " << pulls);
      for (const int frame : {at + 100, at + 1, at + 60, at + 149}) {
        scene.go(at);
        scene.go(frame);
        CHECK(scene.world().hash() == hashes[frame - at - 1]);
      }
      scene.go(at / 2);
      scene.go(at + 150);
      const auto anew = scene.world().hash();
      // An effect is switched at its frame again; where drag pulls to holds of all frames that are taken from now on.
      if (!pulls) CHECK(anew == hashes.back());
      scene.go(at + 20);
      scene.go(at + 150);
      CHECK(scene.world().hash() == anew);
    }
}

TEST_CASE("the bits are those of every other compiler") {
  // Held natively and as WebAssembly: whatever moves a bit of physics moves these.
  Scene scene = opened(bouncing(20, 3));
  scene.go(300);
  CHECK(scene.world().hash() == 1764512853920328569u);
}
