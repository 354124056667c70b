#include "scene/pairs.hpp"

#include <algorithm>

#include "hierarchy/build.hpp"
#include "hierarchy/traverse_pair.hpp"
#include "query/aabb_overlap.hpp"

namespace snug::scene {
namespace {

using Box = Aabb<double, 3>;

Pair pair_of(Index i, Index j) { return {std::min(i, j), std::max(i, j)}; }

/// The axis along which the boxes' middles vary most.
int widest_axis(std::span<const Box> boxes) {
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
  return axis;
}

struct Begin {
  double at, end;
  Index body;
};

std::vector<Pair> sweep_and_prune(std::span<const Box> boxes) {
  std::vector<Pair> pairs;
  if (boxes.empty()) return pairs;
  const int axis = widest_axis(boxes);
  std::vector<Begin> order;
  order.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) order.push_back({boxes[i].min[axis], boxes[i].max[axis], static_cast<Index>(i)});
  std::sort(order.begin(), order.end(), [](const Begin& a, const Begin& b) { return a.at != b.at ? a.at < b.at : a.body < b.body; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && order[j].at <= order[i].end; ++j)
      if (query::aabbs_overlap(boxes[static_cast<std::size_t>(order[i].body)], boxes[static_cast<std::size_t>(order[j].body)]))
        pairs.push_back(pair_of(order[i].body, order[j].body));
  return pairs;
}

std::vector<Pair> by_tree(std::span<const Box> boxes) {
  std::vector<Pair> pairs;
  const hierarchy::Tree<Box> tree = hierarchy::build_median<Box>(boxes);
  hierarchy::overlapping_pairs(tree, boxes, tree, boxes, [&](Index i, Index j) {
    if (i < j) pairs.push_back({i, j});  // each is met both ways round
  });
  return pairs;
}

std::vector<Pair> all_pairs(std::span<const Box> boxes) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (query::aabbs_overlap(boxes[i], boxes[j])) pairs.push_back({static_cast<Index>(i), static_cast<Index>(j)});
  return pairs;
}

}  // namespace

std::vector<Pair> overlapping_pairs(std::span<const Box> boxes, PairSearch search) {
  std::vector<Pair> pairs = search == PairSearch::kTree ? by_tree(boxes) : search == PairSearch::kAllPairs ? all_pairs(boxes) : sweep_and_prune(boxes);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace snug::scene
