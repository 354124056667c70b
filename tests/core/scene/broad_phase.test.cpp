// The broad phase in a scene: its order that is kept from frame to frame, the funnel, and a crowd of 2,000.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/scene/declared.hpp"
#include "geometry/random.hpp"
#include "scene/shape.hpp"

using namespace snug;
using namespace snug::test;

namespace {

Declaration crowd(int count, const char* search) {
  Declaration declaration{.effects = {call("orbit", {{"vary", {0.8}, ""}}), call("spin", {{"axis", {1, 2, 3}, ""}}),
                                      call("refit"), call("broad_phase", {{"search", {}, search}}),
                                      call("narrow_phase")}};
  Random random(11);
  const double side = std::cbrt(count);
  for (int i = 0; i < count; ++i) {
    const V3 at(random.between(-1, 1) * side, random.between(-1, 1) * side, random.between(-1, 1) * side);
    Body body = i % 2 == 0 ? ball(0.4, at) : box({0.4, 0.2, 0.6}, at);
    if (i % 16 == 3) body.shape = scene::Volume3(Capsule<double, 3>{{-0.4, 0, 0}, {0.4, 0, 0}, 0.2});
    body.orientation = normalized({random.unit(), random.unit(), random.unit(), random.unit()});
    declaration.bodies.push_back(body);
  }
  return declaration;
}

}  // namespace

TEST_CASE("going back to a frame repeats its swaps") {
  Scene scene = opened(crowd(60, "sweep_and_prune"));
  std::vector<std::int64_t> swaps;
  for (int frame = 1; frame <= 40; ++frame) scene.step(), swaps.push_back(scene.world().state.funnel.swaps);
  CHECK(swaps.front() > 100);
  CHECK(*std::max_element(swaps.begin() + 1, swaps.end()) < swaps.front() / 2);
  CHECK(*std::max_element(swaps.begin() + 1, swaps.end()) > 0);
  for (const int frame : {20, 3, 33, 17}) {
    scene.go(frame);
    CHECK(scene.world().state.funnel.swaps == swaps[frame - 1]);
  }
}

TEST_CASE("each stage of the funnel leaves fewer pairs and loses none that touch") {
  for (const char* search : {"sweep_and_prune", "tree", "all_pairs", "grid"}) {
    Scene scene = opened(crowd(150, search));
    for (const int frame : {1, 40, 90}) {
      scene.go(frame);
      const auto& state = scene.world().state;
      const auto& bodies = scene.world().bodies;
      const scene::Funnel& funnel = state.funnel;
      CHECK(funnel.all == 150 * 149 / 2);
      CHECK(funnel.after_broad < funnel.all);
      CHECK(funnel.after_loose < funnel.after_broad);
      CHECK(funnel.touching < funnel.after_loose);
      std::int64_t touching = 0;
      for (std::size_t i = 0; i < 150; ++i)
        for (std::size_t j = i + 1; j < 150; ++j) {
          const auto pose = [&](std::size_t k) { return Pose<double, 3>{bodies[k].rotation, bodies[k].position}; };
          touching +=
              scene::touch(scene.world().members[i].shape, pose(i), scene.world().members[j].shape, pose(j)) ? 1 : 0;
        }
      CHECK(funnel.touching == touching);
      CHECK(funnel.touching > 0);
      CHECK(static_cast<std::int64_t>(scene.world().contacts.size()) == touching);
    }
  }
}

TEST_CASE("two thousand moving bodies take much less than a frame") {
  Scene scene = opened(crowd(2000, "sweep_and_prune"));
  scene.go(5);
  const auto start = std::chrono::steady_clock::now();
  scene.go(35);
  const double milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / 30;
  INFO(milliseconds << " ms a frame");
  CHECK(scene.world().state.funnel.all == 1999000);
  CHECK(milliseconds < 160);  // 3 as compiled for use; ten times that with sanitizers, and the machine may be busy
}
