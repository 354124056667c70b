#include "hierarchy/insertion.hpp"

#include <algorithm>
#include <optional>

namespace snug::hierarchy {
namespace {

struct Branch {
  Box box;
  Size size;
  Index parent = kNoIndex;
  Index bodies = 1;
  std::array<Index, 2> children{kNoIndex, kNoIndex};
};

class Insertion {
 public:
  Insertion(const Layout& layout, InsertionFacts* facts)
      : layout_(layout), facts_(facts), groups_(layout.boxes.size()) {
    groups_.reserve(2 * groups_.size());
    for (std::size_t i = 0; i < layout.boxes.size(); ++i) {
      groups_[i].box = layout.boxes[i];
      groups_[i].size = half_surface_of(layout.boxes[i], layout.dim);
    }
  }

  Shape run() {
    const auto bodies = static_cast<Index>(groups_.size());
    for (Index body = 0; body < bodies; ++body) insert(body);
    std::vector<std::array<Index, 2>> pairs;
    for (std::size_t i = bodies; i < groups_.size(); ++i) pairs.push_back(groups_[i].children);
    return shape_of(pairs, bodies, root_);
  }

 private:
  [[nodiscard]] Branch& at(Index i) { return groups_[i]; }
  [[nodiscard]] bool is_body(Index i) { return at(i).children[0] == kNoIndex; }
  [[nodiscard]] Size size_with(Index i, const Box& box) { return half_surface_of(united(at(i).box, box), layout_.dim); }

  void insert(Index body) {
    if (root_ == kNoIndex) {
      root_ = body;
      if (facts_ != nullptr) facts_->push_back(BodyInserted{body, kNoIndex, kNoIndex, 0});
      return;
    }
    Size growth{};
    const Index beside = best_place(body, growth);
    const Index made = pair_with(beside, body);
    if (facts_ != nullptr) facts_->push_back(BodyInserted{body, beside, made, layout_.area(growth)});
    for (Index group = at(made).parent; group != kNoIndex; group = at(group).parent) {
      update(group);
      rotate(group);
    }
  }

  /// Descends from the root until a pair made here costs less than going down: than the growth of this group and of a
  /// child, plus the least that a pair below it can add, the body's own size. growth: of the groups above, and of the
  /// pair.
  Index best_place(Index body, Size& growth) {
    const Box& box = at(body).box;
    Index group = root_;
    Size above{};  // the growth of the groups passed
    for (int depth = 0; depth < kDeepestInsertion && !is_body(group); ++depth) {
      const Size pair_here = size_with(group, box);
      const Size passed = pair_here - at(group).size;
      std::array<Size, 2> below;
      for (std::size_t side = 0; side < 2; ++side) {
        const Index child = at(group).children[side];
        below[side] =
            passed + (is_body(child) ? size_with(child, box) : size_with(child, box) - at(child).size + at(body).size);
      }
      const auto [first, second] = at(group).children;
      const bool fewer_first = at(first).bodies <= at(second).bodies;
      const std::size_t side = below[0] < below[1] || (!(below[1] < below[0]) && fewer_first) ? 0 : 1;
      if (pair_here < below[side]) break;
      above = above + passed;
      group = at(group).children[side];
    }
    growth = above + size_with(group, box);
    return group;
  }

  Index pair_with(Index beside, Index body) {
    const auto made = static_cast<Index>(groups_.size());
    const Index parent = at(beside).parent;
    groups_.push_back({.parent = parent, .children = {beside, body}});
    if (parent == kNoIndex) root_ = made;
    else at(parent).children[at(parent).children[0] == beside ? 0 : 1] = made;
    at(beside).parent = at(body).parent = made;
    update(made);
    return made;
  }

  void update(Index i) {
    Branch& group = at(i);
    const Branch &left = at(group.children[0]), &right = at(group.children[1]);
    group.box = united(left.box, right.box);
    group.size = half_surface_of(group.box, layout_.dim);
    group.bodies = left.bodies + right.bodies;
  }

  /// Four swaps exchange a child with a grandchild below the other child. Does the one that makes that other child
  /// smallest, if it gets smaller.
  void rotate(Index i) {
    struct Swap {
      std::size_t down, up;
      Size gain;
    };
    std::optional<Swap> best;
    for (const std::size_t down : {0u, 1u}) {
      const Branch& other = at(at(i).children[1 - down]);
      if (other.children[0] == kNoIndex) continue;
      for (const std::size_t up : {0u, 1u}) {
        const Size gain = other.size - size_with(at(i).children[down], at(other.children[1 - up]).box);
        if (Size{} < gain && (!best || best->gain < gain)) best = Swap{down, up, gain};
      }
    }
    if (!best) return;
    const Index down = at(i).children[best->down], middle = at(i).children[1 - best->down],
                up = at(middle).children[best->up];
    at(i).children[best->down] = up;
    at(up).parent = i;
    at(middle).children[best->up] = down;
    at(down).parent = middle;
    update(middle);
    if (facts_ != nullptr) facts_->push_back(Rotated{i, down, up, layout_.area(best->gain)});
  }

  const Layout& layout_;
  InsertionFacts* facts_;
  std::vector<Branch> groups_;  // bodies first, then groups as they are made
  Index root_ = kNoIndex;
};

}  // namespace

Shape lay_out_by_insertion(const Layout& layout, InsertionFacts* facts) { return Insertion(layout, facts).run(); }

}  // namespace snug::hierarchy
