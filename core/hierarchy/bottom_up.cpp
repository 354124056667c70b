#include "hierarchy/bottom_up.hpp"

#include <algorithm>
#include <numeric>

namespace snug::hierarchy {
namespace {

struct Group {
  Box box;
  Index bodies = 1;
  Index id = 0;
};

struct Merge {
  Index left, right;
  Size size;
};

/// How near two groups are: less is nearer. bodies: how many both have together.
struct Nearness {
  Size size;
  Index bodies;

  friend bool operator<(const Nearness& a, const Nearness& b) {
    return a.size < b.size || (a.size == b.size && a.bodies < b.bodies);
  }
};

class BottomUp {
 public:
  explicit BottomUp(const Layout& layout) : layout_(layout) {
    for (const Box& box : layout.boxes) groups_.push_back({box, 1, static_cast<Index>(groups_.size())});
  }

  std::vector<Merge> run() {
    std::vector<Index> chain;  // ids
    place_.resize(2 * groups_.size());
    std::iota(place_.begin(), place_.end(), 0);
    Index oldest = 0, next = static_cast<Index>(groups_.size());
    while (groups_.size() > 1) {
      while (place_[oldest] == kNoIndex) ++oldest;
      if (chain.empty()) chain.push_back(oldest);
      const Index last = chain.back(), before = chain.size() > 1 ? chain[chain.size() - 2] : kNoIndex;
      const Index nearest = nearest_to(last, before);
      if (nearest != before) {
        chain.push_back(nearest);
        continue;
      }
      chain.resize(chain.size() - 2);
      merge(std::min(last, before), std::max(last, before), next++);
    }
    return std::move(merges_);
  }

 private:
  [[nodiscard]] const Group& group(Index id) const { return groups_[place_[id]]; }

  /// Among equally near groups it takes the previous one in the chain, so that the chain ends; otherwise the one of
  /// least id.
  [[nodiscard]] Index nearest_to(Index id, Index before) const {
    const Group& own = group(id);
    Index nearest = kNoIndex;
    Nearness least{};
    const auto consider = [&](const Group& other) {
      if (other.id == id) return;
      const Nearness near{half_surface_of(united(own.box, other.box), layout_.dim), own.bodies + other.bodies};
      if (nearest != kNoIndex && least < near) return;
      if (nearest != kNoIndex && !(near < least) && (nearest == before || other.id > nearest)) return;
      least = near;
      nearest = other.id;
    };
    if (before != kNoIndex) consider(group(before));
    for (const Group& other : groups_) consider(other);
    return nearest;
  }

  void merge(Index left, Index right, Index id) {
    const Group merged{united(group(left).box, group(right).box), group(left).bodies + group(right).bodies, id};
    merges_.push_back({left, right, half_surface_of(merged.box, layout_.dim)});
    remove(left);
    remove(right);
    place_[id] = static_cast<Index>(groups_.size());
    groups_.push_back(merged);
  }

  void remove(Index id) {
    const Index place = place_[id];
    groups_[place] = groups_.back();
    place_[groups_.back().id] = place;
    place_[id] = kNoIndex;
    groups_.pop_back();
  }

  const Layout& layout_;
  std::vector<Group> groups_;
  std::vector<Index> place_;  // a group's index in groups_, by its id; kNoIndex: merged
  std::vector<Merge> merges_;
};

/// Sorts the pairs, smallest first, and renumbers the groups in that order. A group is no smaller than its children,
/// and comes after them.
void sort_by_size(std::vector<Merge>& merges, Index bodies) {
  std::vector<Index> order(merges.size()), name(merges.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return merges[a].size < merges[b].size; });
  std::vector<Merge> sorted;
  const auto renamed = [&](Index id) { return id < bodies ? id : name[id - bodies]; };
  for (const Index i : order) {
    name[i] = bodies + static_cast<Index>(sorted.size());
    const Merge& merge = merges[i];
    sorted.push_back({renamed(merge.left), renamed(merge.right), merge.size});
  }
  merges = std::move(sorted);
}

}  // namespace

Shape lay_out_bottom_up(const Layout& layout, std::vector<NodesMerged>* facts) {
  const auto bodies = static_cast<Index>(layout.boxes.size());
  if (bodies == 0) return {};
  std::vector<Merge> merges = BottomUp(layout).run();
  sort_by_size(merges, bodies);
  std::vector<std::array<Index, 2>> pairs;
  for (const Merge& merge : merges) {
    const Index made = bodies + static_cast<Index>(pairs.size());
    pairs.push_back({merge.left, merge.right});
    if (facts != nullptr) facts->push_back({made, merge.left, merge.right, layout.area(merge.size)});
  }
  return shape_of(pairs, bodies, merges.empty() ? 0 : bodies + static_cast<Index>(pairs.size()) - 1);
}

}  // namespace snug::hierarchy
