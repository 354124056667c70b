// All pairs of overlapping boxes, found in four ways.
#include "hierarchy/broad_phase/broad_phase.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "geometry/random.hpp"
#include "hierarchy/broad_phase/grid.hpp"

using namespace snug;
using hierarchy::PairSearch;

namespace {

std::vector<Aabb<double, 3>> boxes(int count, double size, std::uint64_t seed, bool on_grid) {
  Random random(seed);
  std::vector<Aabb<double, 3>> all;
  for (int i = 0; i < count; ++i) {
    Vector<double, 3> at(random.between(-4, 4), random.between(-4, 4), random.between(-1, 1));
    if (on_grid)
      at = Vector<double, 3>(random.below(6), random.below(6), random.below(2));  // many touch, many are the same
    const Vector<double, 3> half(size * random.unit(), size * random.unit(), size);
    all.push_back(on_grid ? Aabb<double, 3>{at, at + Vector<double, 3>::Ones()}
                          : Aabb<double, 3>{at - half, at + half});
  }
  return all;
}

}  // namespace

TEST_CASE("sweep and prune, a tree and a grid find the pairs that trying all finds") {
  for (const bool on_grid : {false, true})
    for (const int count : {1, 2, 3, 50, 400})
      for (const double size : {0.05, 0.3, 3.0}) {
        const auto all = boxes(count, size, static_cast<std::uint64_t>(count), on_grid);
        const auto wanted = hierarchy::broad_phase(all, PairSearch::kAllPairs);
        const auto swept = hierarchy::broad_phase(all, PairSearch::kSweepAndPrune);
        CHECK(swept.pairs == wanted.pairs);
        CHECK(hierarchy::broad_phase(all, PairSearch::kTree).pairs == wanted.pairs);
        const auto gridded = hierarchy::broad_phase(all, PairSearch::kGrid);
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
    for (int i = 0; i < 5; ++i)
      row.push_back(
          {Vector<double, 3>::Unit(axis) * i, Vector<double, 3>::Unit(axis) * i + Vector<double, 3>::Constant(0.5)});
    CHECK(hierarchy::broad_phase(row, PairSearch::kSweepAndPrune).axis == axis);
    CHECK(hierarchy::broad_phase(row, PairSearch::kTree).axis == -1);
  }
  CHECK(hierarchy::broad_phase({}, PairSearch::kSweepAndPrune).pairs.empty());
  CHECK(hierarchy::broad_phase({}, PairSearch::kTree).pairs.empty());
  CHECK(hierarchy::broad_phase({}, PairSearch::kGrid).pairs.empty());
}

TEST_CASE("no search compares two boxes twice, even if all overlap") {
  for (const double size : {0.3, 30.0})
    for (const PairSearch search :
         {PairSearch::kSweepAndPrune, PairSearch::kTree, PairSearch::kAllPairs, PairSearch::kGrid}) {
      const auto all = boxes(120, size, 5, false);
      std::vector<BodyPair> seen;
      const auto found = hierarchy::broad_phase(all, search, nullptr, &seen);
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
  CHECK(hierarchy::broad_phase(all, PairSearch::kGrid).pairs ==
        hierarchy::broad_phase(all, PairSearch::kAllPairs).pairs);
  // Boxes as large as the scene are put into no cells, and are compared with each other and with all others once.
  for (int i = 0; i < 2; ++i) all.insert(all.begin() + 70 * i, {{-100, -100, -100}, {100, 100, 100}});
  std::vector<BodyPair> seen;
  const auto found = hierarchy::broad_phase(all, PairSearch::kGrid, nullptr, &seen);
  CHECK(found.pairs == hierarchy::broad_phase(all, PairSearch::kAllPairs).pairs);
  CHECK(found.cells >= 200);
  CHECK(found.cells < 8 * 200 + hierarchy::kMostCellsOfBox);
  CHECK(found.compared == std::ssize(seen));
  std::sort(seen.begin(), seen.end());
  CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
  const std::vector<Aabb<double, 3>> points(4, Aabb<double, 3>{Vector<double, 3>::Ones(), Vector<double, 3>::Ones()});
  CHECK(hierarchy::broad_phase(points, PairSearch::kGrid).pairs.size() == 6);
}

TEST_CASE("a sweep begins from the last order: it swaps what has changed places, and nothing else") {
  std::vector<Aabb<double, 3>> row;
  for (int i = 0; i < 5; ++i)
    row.push_back({Vector<double, 3>::UnitX() * (4 - i),
                   Vector<double, 3>::UnitX() * (4 - i) + Vector<double, 3>::Constant(0.1)});
  hierarchy::SweepOrder order;
  const auto swaps = [&] { return hierarchy::broad_phase(row, PairSearch::kSweepAndPrune, &order).swaps; };
  CHECK(swaps() == 10);  // the bodies' own order is the wrong way round
  CHECK(order.bodies == std::vector<Index>{4, 3, 2, 1, 0});
  CHECK(swaps() == 0);
  row[3].min[0] += 1.5, row[3].max[0] += 1.5;  // past one of them
  CHECK(swaps() == 1);
  CHECK(order.bodies == std::vector<Index>{4, 2, 3, 1, 0});
  row.pop_back();  // of another number of boxes the old order says nothing
  CHECK(swaps() == 5);
}

TEST_CASE("without a last order a sweep takes no quadratic time, and tells as many swaps as insertion makes") {
  constexpr int kMany = 300'000;
  std::vector<Aabb<double, 3>> row(kMany);
  for (int i = 0; i < kMany; ++i) {
    const Vector<double, 3> at = Vector<double, 3>::UnitX() * (kMany - i);
    row[i] = {at, at + Vector<double, 3>::Constant(0.1)};
  }
  hierarchy::SweepOrder order;
  const auto start = std::chrono::steady_clock::now();
  const auto first = hierarchy::broad_phase(row, PairSearch::kSweepAndPrune, &order);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  CHECK(first.swaps == std::int64_t{kMany} * (kMany - 1) / 2);
  CHECK(first.pairs.empty());
  CHECK(std::is_sorted(order.bodies.rbegin(), order.bodies.rend()));
  INFO(seconds.count() << " s");
  CHECK(seconds.count() < 8);  // 0.1 as compiled for use, where insertion takes 20; more with sanitizers

  // As many as insertion makes from the bodies' own order, whatever that is.
  for (const int count : {1, 2, 3, 7, 64, 101})
    for (const bool on_grid : {false, true}) {
      const auto all = boxes(count, 0.3, static_cast<std::uint64_t>(count) + 40, on_grid);
      const int axis = hierarchy::broad_phase(all, PairSearch::kSweepAndPrune).axis;
      hierarchy::SweepOrder own{axis, std::vector<Index>(all.size())};
      std::iota(own.bodies.begin(), own.bodies.end(), Index{0});
      hierarchy::SweepOrder none;
      const auto inserted = hierarchy::broad_phase(all, PairSearch::kSweepAndPrune, &own);
      const auto merged = hierarchy::broad_phase(all, PairSearch::kSweepAndPrune, &none);
      CHECK(merged.axis == inserted.axis);
      CHECK(merged.swaps == inserted.swaps);
      CHECK(none.bodies == own.bodies);
    }
}
