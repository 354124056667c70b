#include "hierarchy/broad_phase/sweep_and_prune.hpp"

#include <algorithm>
#include <numeric>

namespace snug::hierarchy {
namespace {

/// The axis along which the boxes' centres vary most. The last axis stays unless another varies clearly more, so that
/// its order can be used again.
int widest_axis(std::span<const Aabb<double, 3>> boxes, int last) {
  constexpr double kClearly = 2;
  using Vector3 = Vector<double, 3>;
  Vector3 sum = Vector3::Zero(), squares = Vector3::Zero();
  const Vector3 origin = boxes.front().min;
  for (const Aabb<double, 3>& box : boxes) {
    const Vector3 middle = (box.min - origin) + (box.max - origin);
    sum += middle;
    squares += middle.cwiseProduct(middle);
  }
  const Vector3 spread = squares - sum.cwiseProduct(sum) / static_cast<double>(boxes.size());
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

/// Sorts by insertion. Returns the number of swaps: as many as neighbours have changed places since the last frame,
/// which are few.
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

/// Sorts by merging, for an order that says nothing about this frame: insertion would take O(n^2) time. Returns the
/// number of swaps that insertion would make, one for each two that stand the wrong way round.
std::int64_t sort_by_merging(std::vector<Begin>& order) {
  std::int64_t swaps = 0;
  const std::size_t n = order.size();
  std::vector<Begin> merged(n);
  for (std::size_t width = 1; width < n; width *= 2) {
    for (std::size_t begin = 0; begin < n; begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, n), end = std::min(begin + 2 * width, n);
      std::size_t left = begin, right = middle;
      for (std::size_t to = begin; to < end; ++to) {
        const bool take_right = left == middle || (right < end && order[right] < order[left]);
        if (take_right) swaps += static_cast<std::int64_t>(middle - left);
        merged[to] = order[take_right ? right++ : left++];
      }
    }
    order.swap(merged);
  }
  return swaps;
}

/// Brings the last order up to date. Without one along this axis, it sorts the bodies' own order.
std::vector<Begin> sorted(std::span<const Aabb<double, 3>> boxes, SweepOrder& sweep, int axis, std::int64_t& swaps) {
  const bool has_order = sweep.axis == axis && sweep.bodies.size() == boxes.size();
  if (!has_order) {
    sweep = {axis, std::vector<Index>(boxes.size())};
    std::iota(sweep.bodies.begin(), sweep.bodies.end(), Index{0});
  }
  std::vector<Begin> order;
  order.reserve(boxes.size());
  for (const Index body : sweep.bodies) order.push_back({boxes[body].min[axis], body});
  swaps = has_order ? sort_by_insertion(order) : sort_by_merging(order);
  for (std::size_t i = 0; i < order.size(); ++i) sweep.bodies[i] = order[i].body;
  return order;
}

/// A box with its body's index, so that the sweep reads memory in order.
struct SweptBox {
  Aabb<double, 3> box;
  Index body;
};

}  // namespace

/// There is no list of active boxes: each box is compared with those after it that begin before it ends. These are the
/// same pairs, and nothing has to be dropped from a list.
PairsFound sweep_and_prune(std::span<const Aabb<double, 3>> boxes, SweepOrder& sweep, std::vector<BodyPair>* seen) {
  PairsFound found;
  if (boxes.empty()) return found;
  const int axis = found.axis = widest_axis(boxes, sweep.axis);
  std::vector<SweptBox> order;
  order.reserve(boxes.size());
  for (const Begin& begin : sorted(boxes, sweep, axis, found.swaps)) order.push_back({boxes[begin.body], begin.body});
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  // All four comparisons at once: which of them fails is random, so branches would be mispredicted.
  const auto overlap = [u, v](const Aabb<double, 3>& a, const Aabb<double, 3>& b) {
    return int{a.min[u] > b.max[u]} + int{b.min[u] > a.max[u]} + int{a.min[v] > b.max[v]} + int{b.min[v] > a.max[v]} ==
           0;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::size_t j = i + 1;
    for (; j < order.size() && order[j].box.min[axis] <= order[i].box.max[axis]; ++j) {
      if (seen != nullptr) seen->push_back(BodyPair::of(order[i].body, order[j].body));
      if (overlap(order[i].box, order[j].box)) found.pairs.push_back(BodyPair::of(order[i].body, order[j].body));
    }
    found.compared += static_cast<std::int64_t>(j - i - 1);
  }
  return found;
}

}  // namespace snug::hierarchy
