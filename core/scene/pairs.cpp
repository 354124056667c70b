#include "scene/pairs.hpp"

#include <algorithm>
#include <numeric>

#include "hierarchy/build.hpp"
#include "hierarchy/traverse_self.hpp"
#include "query/overlap/aabb_overlap.hpp"

namespace snug::scene {
namespace {

using Box = Aabb<double, 3>;

Pair pair_of(Index i, Index j) { return {std::min(i, j), std::max(i, j)}; }

/// Ignores which pairs a search compares.
struct Unseen {
  void operator()(Index, Index) const {}
};
struct Seen {
  std::vector<Pair>& pairs;
  void operator()(Index i, Index j) const { pairs.push_back(pair_of(i, j)); }
};

/// The axis along which the boxes' centres vary most. Between axes that vary about as much, the last one stays, so that
/// its order can be used again.
int widest_axis(std::span<const Box> boxes, int last) {
  constexpr double kClearly = 2;
  V3 sum = V3::Zero(), squares = V3::Zero();
  const V3 origin = boxes.front().min;
  for (const Box& box : boxes) {
    const V3 middle = (box.min - origin) + (box.max - origin);
    sum += middle;
    squares += middle.cwiseProduct(middle);
  }
  const V3 spread = squares - sum.cwiseProduct(sum) / static_cast<double>(boxes.size());
  int axis = 0;
  spread.maxCoeff(&axis);
  return last >= 0 && spread[axis] <= kClearly * spread[last] ? last : axis;
}

/// Where a box begins along the axis, with its body's index.
struct Begin {
  double at;
  Index body;
  friend bool operator<(const Begin& a, const Begin& b) { return a.at != b.at ? a.at < b.at : a.body < b.body; }
};

/// Sorts by insertion: as many swaps as neighbours have changed places since the last frame, which are few. Returns how
/// many those were.
std::int64_t sort_by_insertion(std::vector<Begin>& order) {
  std::int64_t swaps = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Begin moving = order[i];
    std::size_t to = i;
    for (; to > 0 && moving < order[to - 1]; --to) order[to] = order[to - 1];
    order[to] = moving;
    swaps += static_cast<std::int64_t>(i - to);
  }
  return swaps;
}

/// Brings the kept order up to date; where there is none along this axis, the bodies' own order is sorted.
std::vector<Begin> sorted(std::span<const Box> boxes, SweepOrder& sweep, int axis, std::int64_t& swaps) {
  if (sweep.axis != axis || sweep.bodies.size() != boxes.size()) {
    sweep = {axis, std::vector<Index>(boxes.size())};
    std::iota(sweep.bodies.begin(), sweep.bodies.end(), Index{0});
  }
  std::vector<Begin> order;
  order.reserve(boxes.size());
  for (const Index body : sweep.bodies) order.push_back({boxes[body].min[axis], body});
  swaps = sort_by_insertion(order);
  for (std::size_t i = 0; i < order.size(); ++i) sweep.bodies[i] = order[i].body;
  return order;
}

/// A box with its body's index, so that the sweep reads memory in order.
struct Swept {
  Box box;
  Index body;
};

/// Instead of a list of active boxes, each box is compared with those after it that begin before it ends: the same
/// pairs, and nothing has to be dropped from a list.
template <class Watch>
PairsFound sweep_and_prune(std::span<const Box> boxes, SweepOrder& sweep, Watch watch) {
  PairsFound found;
  if (boxes.empty()) return found;
  const int axis = found.axis = widest_axis(boxes, sweep.axis);
  std::vector<Swept> order;
  order.reserve(boxes.size());
  for (const Begin& begin : sorted(boxes, sweep, axis, found.swaps)) order.push_back({boxes[begin.body], begin.body});
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  // All four comparisons at once: which of them fails is random, so branches would be
  // mispredicted.
  const auto overlap = [u, v](const Box& a, const Box& b) {
    return int{a.min[u] > b.max[u]} + int{b.min[u] > a.max[u]} + int{a.min[v] > b.max[v]} + int{b.min[v] > a.max[v]} ==
           0;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::size_t j = i + 1;
    for (; j < order.size() && order[j].box.min[axis] <= order[i].box.max[axis]; ++j) {
      watch(order[i].body, order[j].body);
      if (overlap(order[i].box, order[j].box)) found.pairs.push_back(pair_of(order[i].body, order[j].body));
    }
    found.compared += static_cast<std::int64_t>(j - i - 1);
  }
  return found;
}

/// Tells which bodies a traversal compares.
template <class Watch>
struct SeeBodies {
  Watch watch;
  void operator()(const hierarchy::Step& step) const {
    const auto* tested = std::get_if<hierarchy::PairTested>(&step.fact);
    if (tested != nullptr && tested->bodies) watch(tested->a, tested->b);
  }
  void count(Operation, std::int64_t) const {}
};

template <class Watch>
PairsFound by_tree(std::span<const Box> boxes, Watch watch) {
  PairsFound found;
  const hierarchy::Tree<Box> tree = hierarchy::build_median<Box>(boxes);
  const auto report = [&](Index i, Index j) { found.pairs.push_back(pair_of(i, j)); };
  hierarchy::Counts counts;
  if constexpr (std::is_same_v<Watch, Unseen>) counts = hierarchy::overlapping_pairs_within(tree, boxes, report);
  else counts = hierarchy::overlapping_pairs_within(tree, boxes, report, SeeBodies<Watch>{watch});
  found.compared = counts.volume_tests();
  return found;
}

template <class Watch>
PairsFound all_pairs(std::span<const Box> boxes, Watch watch) {
  PairsFound found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      watch(static_cast<Index>(i), static_cast<Index>(j));
      if (query::aabbs_overlap(boxes[i], boxes[j]))
        found.pairs.push_back({static_cast<Index>(i), static_cast<Index>(j)});
    }
  const auto n = static_cast<std::int64_t>(boxes.size());
  found.compared = n * (n - 1) / 2;
  return found;
}

/// A body in a cell of the grid, which its box reaches into.
struct InCell {
  std::uint64_t key;
  Index body;
  friend bool operator<(const InCell& a, const InCell& b) { return a.key != b.key ? a.key < b.key : a.body < b.body; }
};

constexpr double kMostCells = 64;  // along an axis: a box much larger than the others must not reach into too many

std::uint64_t key_of(const Grid::Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t at : cell) key = key << 16 | static_cast<std::uint64_t>(at);
  return key;
}

std::vector<InCell> boxes_in_cells(std::span<const Box> boxes, const Grid& grid) {
  std::vector<InCell> all;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Grid::Cell from = grid.cell_of(boxes[i].min), to = grid.cell_of(boxes[i].max);
    for (std::int64_t x = from[0]; x <= to[0]; ++x)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t z = from[2]; z <= to[2]; ++z) all.push_back({key_of({x, y, z}), static_cast<Index>(i)});
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Two boxes may share several cells. They are compared in the first one: that where the later of both begins.
template <class Watch>
PairsFound by_grid(std::span<const Box> boxes, Watch watch) {
  PairsFound found;
  if (boxes.empty()) return found;
  const Grid grid = grid_of(boxes);
  const std::vector<InCell> all = boxes_in_cells(boxes, grid);
  const auto first_shared = [&](Index i, Index j) { return key_of(grid.cell_of(boxes[i].min.cwiseMax(boxes[j].min))); };
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size() && all[j].key == all[i].key; ++j) {
      const Index a = all[i].body, b = all[j].body;
      if (first_shared(a, b) != all[i].key) continue;
      ++found.compared;
      watch(a, b);
      if (query::aabbs_overlap(boxes[a], boxes[b])) found.pairs.push_back(pair_of(a, b));
    }
  return found;
}

template <class Watch>
PairsFound found_by(std::span<const Box> boxes, PairSearch search, SweepOrder& sweep, Watch watch) {
  switch (search) {
    case PairSearch::kTree: return by_tree(boxes, watch);
    case PairSearch::kAllPairs: return all_pairs(boxes, watch);
    case PairSearch::kGrid: return by_grid(boxes, watch);
    case PairSearch::kSweepAndPrune: break;
  }
  return sweep_and_prune(boxes, sweep, watch);
}

}  // namespace

Grid::Cell Grid::cell_of(const V3& place) const {
  Cell at{};
  for (int i = 0; i < 3; ++i)
    at[i] = static_cast<std::int64_t>(std::clamp((place[i] - origin[i]) / cell[i], 0.0, 2 * kMostCells));
  return at;
}

Grid grid_of(std::span<const Box> boxes) {
  V3 least = boxes.front().min, greatest = boxes.front().max, sum = V3::Zero();
  for (const Box& box : boxes) {
    least = least.cwiseMin(box.min), greatest = greatest.cwiseMax(box.max);
    sum += box.max - box.min;
  }
  Grid grid{least, 2 * sum / static_cast<double>(boxes.size())};
  grid.cell = grid.cell.cwiseMax((greatest - least) / kMostCells);
  for (int i = 0; i < 3; ++i)
    if (!(grid.cell[i] > 0)) grid.cell[i] = 1;  // all boxes are flat, and in one plane
  return grid;
}

PairsFound overlapping_pairs(std::span<const Box> boxes, PairSearch search, SweepOrder* sweep,
                             std::vector<Pair>* seen) {
  SweepOrder none;
  SweepOrder& order = sweep != nullptr ? *sweep : none;
  PairsFound found =
      seen != nullptr ? found_by(boxes, search, order, Seen{*seen}) : found_by(boxes, search, order, Unseen{});
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

}  // namespace snug::scene
