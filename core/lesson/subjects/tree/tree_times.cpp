#include "lesson/subjects/tree/tree_times.hpp"

#include <algorithm>

#include "geometry/random.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/cost.hpp"

namespace snug::lesson {
namespace {

constexpr double kCrowdReach = 0.7;                      // how far a crowd's centres are from the box's, in x and in y
constexpr double kCrowdLeast = 0.06, kCrowdMost = 0.25;  // of the box's half extents
constexpr std::uint64_t kCrowdSeed = 11;

/// How long a run takes, in nanoseconds: the mean of enough runs for a coarse clock. None without a clock, and then
/// there is one run.
std::optional<double> time_of(Clock clock, auto&& run) {
  constexpr double kEnough = 1.5e6;  // ns: fifteen steps of the coarsest clock of a browser
  constexpr int kMostRuns = 4096;
  if (clock == nullptr) return run(), std::nullopt;
  for (int runs = 1;; runs *= 4) {
    const double begin = clock();
    for (int i = 0; i < runs; ++i) run();
    const double spent = clock() - begin;
    if (spent >= kEnough || runs >= kMostRuns) return spent / runs;
  }
}

TreeOfBoxes built_unwatched(std::string_view method, std::span<const Box2> boxes) {
  const hierarchy::Options single{.most_in_leaf = 1};
  if (method == "top_down_median") return hierarchy::build_median<Box2>(boxes, single);
  if (method == "top_down_sah") return hierarchy::build_surface_area<Box2>(boxes, single);
  if (method == "bottom_up") return hierarchy::build_bottom_up<Box2>(boxes);
  return hierarchy::build_by_insertion<Box2>(boxes);
}

}  // namespace

std::vector<Box2> crowd_of(std::span<const Box2> boxes) {
  Random random(kCrowdSeed);
  std::vector<Box2> crowd;
  for (int i = 0; i < kCrowd; ++i) {
    const Box2& box = boxes[i % boxes.size()];
    const Point2 half = (box.max - box.min) / 2 * random.between(kCrowdLeast, kCrowdMost);
    Point2 center = (box.min + box.max) / 2;
    for (const int axis : {0, 1}) center[axis] += random.between(-kCrowdReach, kCrowdReach);
    crowd.push_back({center - half, center + half});
  }
  return crowd;
}

TreeTime time_of_building(std::string_view method, std::span<const Box2> crowd, Clock clock) {
  TreeOfBoxes tree;
  const auto ns = time_of(clock, [&] { tree = built_unwatched(method, crowd); });
  return {hierarchy::expected_cost(tree), ns};
}

TreeTime time_of_refitting(std::span<const Box2> built, std::span<const Box2> crowd, Clock clock) {
  TreeOfBoxes tree = built_unwatched("top_down_sah", built);
  const auto ns = time_of(clock, [&] { hierarchy::refit(tree, crowd); });
  return {hierarchy::expected_cost(tree), ns};
}

}  // namespace snug::lesson
