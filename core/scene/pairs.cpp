#include "scene/pairs.hpp"

#include <algorithm>

#include "hierarchy/build.hpp"
#include "hierarchy/traverse_pair.hpp"
#include "query/aabb_overlap.hpp"

namespace snug::scene {
namespace {

using Box = Aabb<double, 3>;

Pair pair_of(Index i, Index j) { return {std::min(i, j), std::max(i, j)}; }

/// The axis along which the boxes' centres vary most.
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

/// A box with its body's index, so that the sweep reads memory in order.
struct Swept {
  Box box;
  Index body;
};

PairsFound sweep_and_prune(std::span<const Box> boxes) {
  PairsFound found;
  if (boxes.empty()) return found;
  const int axis = found.axis = widest_axis(boxes);
  std::vector<Swept> order;
  order.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) order.push_back({boxes[i], static_cast<Index>(i)});
  std::sort(order.begin(), order.end(), [axis](const Swept& a, const Swept& b) {
    return a.box.min[axis] != b.box.min[axis] ? a.box.min[axis] < b.box.min[axis] : a.body < b.body;
  });
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  // All four comparisons at once: which of them fails is random, so branches would be
  // mispredicted.
  const auto overlap = [u, v](const Box& a, const Box& b) {
    return int{a.min[u] > b.max[u]} + int{b.min[u] > a.max[u]} + int{a.min[v] > b.max[v]} + int{b.min[v] > a.max[v]} ==
           0;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::size_t j = i + 1;
    for (; j < order.size() && order[j].box.min[axis] <= order[i].box.max[axis]; ++j)
      if (overlap(order[i].box, order[j].box)) found.pairs.push_back(pair_of(order[i].body, order[j].body));
    found.compared += static_cast<std::int64_t>(j - i - 1);
  }
  return found;
}

PairsFound by_tree(std::span<const Box> boxes) {
  PairsFound found;
  const hierarchy::Tree<Box> tree = hierarchy::build_median<Box>(boxes);
  const auto counts = hierarchy::overlapping_pairs(tree, boxes, tree, boxes, [&](Index i, Index j) {
    if (i < j) found.pairs.push_back({i, j});  // each pair is found twice
  });
  found.compared = counts.volume_tests();
  return found;
}

PairsFound all_pairs(std::span<const Box> boxes) {
  PairsFound found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (query::aabbs_overlap(boxes[i], boxes[j]))
        found.pairs.push_back({static_cast<Index>(i), static_cast<Index>(j)});
  const auto n = static_cast<std::int64_t>(boxes.size());
  found.compared = n * (n - 1) / 2;
  return found;
}

}  // namespace

PairsFound overlapping_pairs(std::span<const Box> boxes, PairSearch search) {
  PairsFound found = search == PairSearch::kTree       ? by_tree(boxes)
                     : search == PairSearch::kAllPairs ? all_pairs(boxes)
                                                       : sweep_and_prune(boxes);
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

}  // namespace snug::scene
