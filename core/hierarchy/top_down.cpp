#include "hierarchy/top_down.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace snug::hierarchy {
namespace {

// From this depth on every node that is no leaf is split in half, so that no scene makes a deep tree.
constexpr int kMostUneven = 40;

/// A node's bodies: from begin to end.
struct Part {
  Index node, begin, end;
  int depth;

  [[nodiscard]] Index count() const { return end - begin; }
};

/// How a node's bodies are divided between its children, by either rule. position: a coordinate in the layout, of the
/// first centre on the right (median) or of the border between bins.
struct NodeSplit {
  int axis = kNoIndex;
  double position = 0;
  Index left = 0;
  double cost = sah::kInfinity;  // in tests of a body
};

class TopDown {
 public:
  TopDown(const Layout& layout, SplitRule rule, Index most_in_leaf, TopDownFacts* facts)
      : layout_(layout), rule_(rule), most_in_leaf_(most_in_leaf), facts_(facts) {}

  Shape run() {
    const auto n = static_cast<Index>(layout_.boxes.size());
    if (n == 0) return {};
    bodies_.resize(layout_.boxes.size());
    std::iota(bodies_.begin(), bodies_.end(), 0);
    shape_.nodes.emplace_back();
    std::vector<Part> open{{0, 0, n, 0}};
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      if (const auto split = divide(part)) make_children(part, *split, open);
      else make_leaf(part);
    }
    shape_.bodies = std::move(bodies_);
    return std::move(shape_);
  }

 private:
  [[nodiscard]] double center(Index body, int axis) const { return layout_.center(body, axis); }
  [[nodiscard]] std::span<Index> bodies_of(const Part& part) {
    return std::span(bodies_).subspan(part.begin, part.count());
  }
  [[nodiscard]] auto begin_of(const Part& part) { return bodies_.begin() + part.begin; }
  [[nodiscard]] auto end_of(const Part& part) { return bodies_.begin() + part.end; }

  /// Divides a node's bodies, the left child's first; nothing if it becomes a leaf.
  std::optional<NodeSplit> divide(const Part& part) {
    const bool few = part.count() <= most_in_leaf_;
    const bool by_median = rule_ == SplitRule::kMedian || part.depth >= kMostUneven;
    if (part.count() == 1 || (few && by_median)) return std::nullopt;
    const Box centers = centers_of(part);
    if (by_median) return halve(part, centers);
    sah::Bin all;
    for (const Index body : bodies_of(part)) all.take({layout_.boxes[body], 1});
    const NodeSplit best = cheapest(part, all.box, centers);
    if (few && part.count() <= best.cost) return std::nullopt;
    return best.axis != kNoIndex ? best : halve(part, centers);
  }

  [[nodiscard]] Box centers_of(const Part& part) const {
    Box centers = sah::Bin().box;
    for (Index i = part.begin; i < part.end; ++i)
      for (int axis = 0; axis < layout_.dim; ++axis) {
        const double at = center(bodies_[i], axis);
        centers.low[axis] = std::min(centers.low[axis], at);
        centers.high[axis] = std::max(centers.high[axis], at);
      }
    return centers;
  }

  /// Splits at the median along the axis where the centres spread most, equal ones by index. This is always possible.
  NodeSplit halve(const Part& part, const Box& centers) {
    const auto spread = [&](int axis) { return centers.high[axis] - centers.low[axis]; };
    int axis = 0;
    for (int i = 1; i < layout_.dim; ++i)
      if (spread(i) > spread(axis)) axis = i;
    const Index left = part.count() / 2;
    const auto middle = begin_of(part) + left;
    std::nth_element(begin_of(part), middle, end_of(part), [&](Index a, Index b) {
      return center(a, axis) < center(b, axis) || (center(a, axis) == center(b, axis) && a < b);
    });
    return {spread(axis) > 0 ? axis : kNoIndex, center(*middle, axis), left, 0};
  }

  /// The split that the surface-area heuristic rates cheapest. Its axis is kNoIndex if all centres are in one place.
  NodeSplit cheapest(const Part& part, const Box& all, const Box& centers) {
    std::vector<double> costs;
    if (facts_ != nullptr) costs.assign(static_cast<std::size_t>(layout_.dim * sah::kBorders), sah::kInfinity);
    const sah::BinSplit best =
        sah::best_split(layout_, bodies_of(part), all, centers, facts_ != nullptr ? &costs : nullptr);
    if (best.axis == kNoIndex) return {};
    if (facts_ != nullptr) facts_->push_back(priced(part.node, best.axis, best.border, centers, std::move(costs)));
    sah::reorder(layout_, bodies_of(part), centers, best);
    return {best.axis, best.position, best.left, best.cost};
  }

  [[nodiscard]] SplitsPriced priced(Index node, int axis, int border, const Box& centers,
                                    std::vector<double> costs) const {
    SplitsPriced fact{.node = node, .axis = axis, .border = border, .low = {}, .high = {}, .costs = std::move(costs)};
    for (int along = 0; along < layout_.dim; ++along) {
      fact.low.push_back(layout_.position(along, centers.low[along]));
      fact.high.push_back(layout_.position(along, centers.high[along]));
    }
    return fact;
  }

  void make_leaf(const Part& part) {
    std::sort(begin_of(part), end_of(part));
    shape_.nodes[part.node] = {part.begin, part.count()};
    if (facts_ != nullptr) facts_->push_back(LeafMade{part.node, part.count()});
  }

  void make_children(const Part& part, const NodeSplit& split, std::vector<Part>& open) {
    const auto left = static_cast<Index>(shape_.nodes.size());
    const Index middle = part.begin + split.left;
    shape_.nodes[part.node] = {left, 0};
    shape_.nodes.resize(shape_.nodes.size() + 2);
    open.push_back({left + 1, middle, part.end, part.depth + 1});
    open.push_back({left, part.begin, middle, part.depth + 1});
    if (facts_ == nullptr) return;
    const double position = split.axis == kNoIndex ? 0 : layout_.position(split.axis, split.position);
    facts_->push_back(SplitChosen{part.node, split.axis, position, split.left, part.end - middle, split.cost});
  }

  const Layout& layout_;
  SplitRule rule_;
  Index most_in_leaf_;
  TopDownFacts* facts_;
  std::vector<Index> bodies_;
  Shape shape_;
};

}  // namespace

Shape lay_out_top_down(const Layout& layout, SplitRule rule, Index most_in_leaf, TopDownFacts* facts) {
  return TopDown(layout, rule, most_in_leaf, facts).run();
}

}  // namespace snug::hierarchy
