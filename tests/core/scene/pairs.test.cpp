// Pairs of overlapping boxes, found in four ways; the funnel; and a crowd of 2,000.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/scene/declared.hpp"
#include "geometry/random.hpp"
#include "query/overlap/overlaps.hpp"
#include "scene/pairs.hpp"
#include "scene/shape.hpp"

using namespace snug;
using namespace snug::test;
using scene::PairSearch;

namespace {

std::vector<Aabb<double, 3>> boxes(int count, double size, std::uint64_t seed, bool on_grid) {
  Random random(seed);
  std::vector<Aabb<double, 3>> all;
  for (int i = 0; i < count; ++i) {
    V3 at(random.between(-4, 4), random.between(-4, 4), random.between(-1, 1));
    if (on_grid) at = V3(random.below(6), random.below(6), random.below(2));  // many touch, many are the same
    const V3 half(size * random.unit(), size * random.unit(), size);
    all.push_back(on_grid ? Aabb<double, 3>{at, at + V3::Ones()} : Aabb<double, 3>{at - half, at + half});
  }
  return all;
}

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

TEST_CASE("sweep and prune, a tree and a grid find the pairs that trying all finds") {
  for (const bool on_grid : {false, true})
    for (const int count : {1, 2, 3, 50, 400})
      for (const double size : {0.05, 0.3, 3.0}) {
        const auto all = boxes(count, size, static_cast<std::uint64_t>(count), on_grid);
        const auto wanted = scene::overlapping_pairs(all, PairSearch::kAllPairs);
        const auto swept = scene::overlapping_pairs(all, PairSearch::kSweepAndPrune);
        CHECK(swept.pairs == wanted.pairs);
        CHECK(scene::overlapping_pairs(all, PairSearch::kTree).pairs == wanted.pairs);
        const auto gridded = scene::overlapping_pairs(all, PairSearch::kGrid);
        CHECK(gridded.pairs == wanted.pairs);
        CHECK(gridded.compared <= wanted.compared);
        CHECK(wanted.axis == -1);
        CHECK((swept.axis >= 0 && swept.axis < 3));
        const auto n = static_cast<std::int64_t>(all.size());
        CHECK(wanted.compared == n * (n - 1) / 2);
        CHECK(swept.compared <= wanted.compared);
        CHECK(swept.compared >= static_cast<std::int64_t>(swept.pairs.size()));
        if (count == 400) CHECK_FALSE(wanted.pairs.empty());
      }
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Aabb<double, 3>> row;
    for (int i = 0; i < 5; ++i) row.push_back({V3::Unit(axis) * i, V3::Unit(axis) * i + V3::Constant(0.5)});
    CHECK(scene::overlapping_pairs(row, PairSearch::kSweepAndPrune).axis == axis);
    CHECK(scene::overlapping_pairs(row, PairSearch::kTree).axis == -1);
  }
  CHECK(scene::overlapping_pairs({}, PairSearch::kSweepAndPrune).pairs.empty());
  CHECK(scene::overlapping_pairs({}, PairSearch::kTree).pairs.empty());
  CHECK(scene::overlapping_pairs({}, PairSearch::kGrid).pairs.empty());
}

TEST_CASE("no search compares two boxes twice, even if all overlap") {
  for (const double size : {0.3, 30.0})
    for (const PairSearch search :
         {PairSearch::kSweepAndPrune, PairSearch::kTree, PairSearch::kAllPairs, PairSearch::kGrid}) {
      const auto all = boxes(120, size, 5, false);
      std::vector<scene::Pair> seen;
      const auto found = scene::overlapping_pairs(all, search, nullptr, &seen);
      CHECK(found.compared >= std::ssize(seen));  // a tree compares its nodes as well
      if (search != PairSearch::kTree) CHECK(found.compared == std::ssize(seen));
      std::sort(seen.begin(), seen.end());
      CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
      CHECK(std::includes(seen.begin(), seen.end(), found.pairs.begin(), found.pairs.end()));
    }
}

TEST_CASE("a much larger box does not spoil the grid, and flat boxes have one") {
  auto all = boxes(200, 0.05, 9, false);
  all.push_back({{-100, -100, -100}, {100, -50, 100}});
  CHECK(scene::overlapping_pairs(all, PairSearch::kGrid).pairs ==
        scene::overlapping_pairs(all, PairSearch::kAllPairs).pairs);
  const std::vector<Aabb<double, 3>> points(4, Aabb<double, 3>{V3::Ones(), V3::Ones()});
  CHECK(scene::overlapping_pairs(points, PairSearch::kGrid).pairs.size() == 6);
}

TEST_CASE("a sweep begins from the last order: it swaps what has changed places, and nothing else") {
  std::vector<Aabb<double, 3>> row;
  for (int i = 0; i < 5; ++i) row.push_back({V3::UnitX() * (4 - i), V3::UnitX() * (4 - i) + V3::Constant(0.1)});
  scene::SweepOrder order;
  const auto swaps = [&] { return scene::overlapping_pairs(row, PairSearch::kSweepAndPrune, &order).swaps; };
  CHECK(swaps() == 10);  // the bodies' own order is the wrong way round
  CHECK(order.bodies == std::vector<Index>{4, 3, 2, 1, 0});
  CHECK(swaps() == 0);
  row[3].min[0] += 1.5, row[3].max[0] += 1.5;  // past one of them
  CHECK(swaps() == 1);
  CHECK(order.bodies == std::vector<Index>{4, 2, 3, 1, 0});
  row.pop_back();  // of another number of boxes the old order says nothing
  CHECK(swaps() == 5);
}

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
