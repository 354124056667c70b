#include "hierarchy/top_down.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/tolerance.hpp"

// Nothing here passes a vector between functions that are not inlined, so no calling convention for it matters.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#define SNUG_INLINE [[gnu::always_inline]] inline

namespace snug::hierarchy {
namespace {

typedef float Lanes __attribute__((vector_size(16)));
typedef std::int32_t WholeLanes __attribute__((vector_size(16)));

// Fewer bins are quicker looked through where there are few bodies to fall into them.
constexpr int kMostBins = 16, kFewBins = 8;
constexpr Index kFew = 64;
constexpr Index kSweptExactly = 8;
// A node with more than twice as many bodies looks at about so many to choose a border; they say as well where it goes.
constexpr Index kSample = 1024;
// Beyond it every node is halved, so that no scene makes a deep tree.
constexpr int kMostUneven = 40;
// A node this small beside its frame is seen in a frame of its own, before the floats run out of digits.
constexpr float kTooSmall = 0x1p-8f;

/// A body's box in floats. The fourth lanes are its index, in two halves that floats hold.
struct Body {
  Lanes low, high;

  [[nodiscard]] SNUG_INLINE Index index() const {
    return static_cast<Index>(low[3]) + (static_cast<Index>(high[3]) << 16);
  }
  /// Twice the centre.
  [[nodiscard]] SNUG_INLINE Lanes center() const { return low + high; }
};

SNUG_INLINE Lanes lesser(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
SNUG_INLINE Lanes greater(const Lanes& a, const Lanes& b) { return a > b ? a : b; }

struct Bounds {
  Lanes low, high;

  SNUG_INLINE static Bounds none() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return {Lanes{kInfinity, kInfinity, kInfinity, kInfinity}, Lanes{-kInfinity, -kInfinity, -kInfinity, -kInfinity}};
  }
  SNUG_INLINE void take(const Lanes& least, const Lanes& most) { low = lesser(low, least), high = greater(high, most); }
  [[nodiscard]] SNUG_INLINE Lanes extent() const { return high - low; }
};

/// Where the floats of some bodies count from, and in what unit.
struct Frame {
  std::array<double, 3> origin{};
  double scale = 1;
};

struct Work {
  Index node, begin, end;
  int depth;
  Frame frame;
  Bounds bounds, centers;
};

struct Choice {
  int axis = kNoIndex;
  Index left = 0;
  float position = 0;  // of twice the centre, in the frame
  float cost = std::numeric_limits<float>::infinity();
};

class TopDown {
 public:
  TopDown(const Layout& layout, SplitRule rule, Index most_in_leaf, TopDownFacts* facts)
      : layout_(layout), rule_(rule), most_in_leaf_(most_in_leaf), facts_(facts) {}

  Shape run() {
    const auto n = static_cast<Index>(layout_.boxes.size());
    if (n == 0) return {};
    bodies_.resize(layout_.boxes.size());
    if (rule_ == SplitRule::kSurfaceArea) copies_.resize(layout_.boxes.size());
    for (Index i = 0; i < n; ++i) place(bodies_[i], i, {});
    shape_.nodes.reserve(layout_.boxes.size());
    shape_.nodes.emplace_back();
    Work root{0, 0, n, 0, {}, Bounds::none(), Bounds::none()};
    measure(root);
    std::vector<Work> open{root};
    while (!open.empty()) {
      Work work = open.back();
      open.pop_back();
      if (split(work)) {
        const auto& [left, right] = halves_;
        open.push_back(right), open.push_back(left);
      }
    }
    list_bodies();
    return std::move(shape_);
  }

 private:
  SNUG_INLINE void place(Body& body, Index index, const Frame& frame) const {
    const Box& box = layout_.boxes[index];
    for (std::size_t i = 0; i < 3; ++i) {
      body.low[i] = static_cast<float>((box.low[i] - frame.origin[i]) * frame.scale);
      body.high[i] = static_cast<float>((box.high[i] - frame.origin[i]) * frame.scale);
    }
    body.low[3] = static_cast<float>(index & 0xffff);
    body.high[3] = static_cast<float>(index >> 16);
  }

  SNUG_INLINE void measure(Work& work) const {
    Bounds bounds = Bounds::none(), centers = bounds;
    for (Index i = work.begin; i < work.end; ++i) {
      const Body& body = bodies_[i];
      bounds.take(body.low, body.high);
      centers.take(body.center(), body.center());
    }
    work.bounds = bounds, work.centers = centers;
  }

  [[nodiscard]] static float largest(const Lanes& extent) { return std::max({extent[0], extent[1], extent[2]}); }

  /// A frame of the node's own, where it is too small for that which it is in.
  void look_closer(Work& work) {
    if (largest(work.bounds.extent()) >= kTooSmall) return;
    Box box = layout_.boxes[at(work.begin).index()];
    for (Index i = work.begin; i < work.end; ++i) box = united(box, layout_.boxes[at(i).index()]);
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, box.high[i] - box.low[i]);
    const double scale = extent > 0 ? std::ldexp(1.0, -std::max(std::ilogb(extent), -1000)) : work.frame.scale;
    if (scale == work.frame.scale) return;
    work.frame = {box.low, scale};
    for (Index i = work.begin; i < work.end; ++i) place(at(i), at(i).index(), work.frame);
    measure(work);
  }

  /// Half the surface; of what has none, and in the plane, the edges' lengths.
  [[nodiscard]] SNUG_INLINE float size(const Bounds& bounds, bool by_length) const {
    const Lanes d = bounds.extent();
    return by_length ? d[0] + d[1] + d[2] : d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }

  /// Makes a leaf, or two halves.
  bool split(Work& work) {
    const Index count = work.end - work.begin;
    if (count <= (rule_ == SplitRule::kMedian ? most_in_leaf_ : std::min<Index>(most_in_leaf_, 2)))
      return make_leaf(work);
    look_closer(work);
    Choice choice;
    are_measured_ = false;
    if (rule_ == SplitRule::kSurfaceArea && work.depth < kMostUneven) {
      const bool by_length = layout_.dim == 2 || size(work.bounds, false) == 0;
      const float whole = size(work.bounds, by_length);
      choice = count <= kSweptExactly ? sweep(work, by_length) : bin(work, by_length);
      // One test of each child and then what is expected of their bodies, against all bodies.
      if (count <= most_in_leaf_ && whole * static_cast<float>(count - 2) <= choice.cost) return make_leaf(work);
      choice.cost = whole > 0 ? 2 + choice.cost / whole : 2;
      if (choice.axis != kNoIndex) {
        if (count <= kSweptExactly) take_swept(work);
        else partition(work, choice);
      }
    }
    if (choice.axis == kNoIndex) choice = halve(work);
    make_halves(work, choice);
    return true;
  }

  bool make_leaf(const Work& work) {
    shape_.nodes[work.node] = {work.begin, work.end - work.begin};
    if (facts_ != nullptr) facts_->push_back(LeafMade{work.node, work.end - work.begin});
    return false;
  }

  void make_halves(const Work& work, const Choice& choice) {
    const auto left = static_cast<Index>(shape_.nodes.size());
    shape_.nodes[work.node] = {left, 0};
    shape_.nodes.resize(shape_.nodes.size() + 2);
    const Index middle = work.begin + choice.left;
    halves_[0] = Work{left, work.begin, middle, work.depth + 1, work.frame, halves_[0].bounds, halves_[0].centers};
    halves_[1] = Work{left + 1, middle, work.end, work.depth + 1, work.frame, halves_[1].bounds, halves_[1].centers};
    if (!are_measured_)
      for (Work& half : halves_) measure(half);
    if (facts_ == nullptr) return;
    double position = 0;
    if (choice.axis != kNoIndex) {
      const double local = static_cast<double>(choice.position) / 2 / work.frame.scale;
      position = layout_.position(choice.axis, work.frame.origin[choice.axis] + local);
    }
    facts_->push_back(SplitChosen{work.node, choice.axis, position, choice.left, work.end - middle,
                                  static_cast<double>(choice.cost)});
  }

  /// At the median along the axis where centres spread most, equal ones by index: always to be had.
  Choice halve(const Work& work) {
    const Lanes spread = work.centers.extent();
    int axis = 0;
    for (int i = 1; i < layout_.dim; ++i)
      if (spread[i] > spread[axis]) axis = i;
    const auto begin = bodies_.begin() + work.begin, end = bodies_.begin() + work.end;
    const Index left = (work.end - work.begin) / 2;
    const auto before = [axis](const Body& a, const Body& b) {
      const float of_a = a.center()[axis], of_b = b.center()[axis];
      return of_a < of_b || (of_a == of_b && a.index() < b.index());
    };
    // The halves are the same everywhere, their order is the library's: it must not matter further down.
    if (rule_ == SplitRule::kMedian) std::nth_element(begin, begin + left, end, before);
    else std::sort(begin, end, before);
    return {spread[axis] > 0 ? axis : kNoIndex, left, at(work.begin + left).center()[axis], 0};
  }

  // -- Few bodies: every border between two
  // ---------------------------------------------------------------------------------

  using Order = std::array<std::int32_t, kSweptExactly>;

  /// The bodies by rising centre along an axis, equal ones as they are: by how many come before each, for branches that
  /// are guessed wrong cost more than comparisons.
  SNUG_INLINE void sort_along(int axis, const Body* bodies, Index count, Order& order,
                              std::array<float, kSweptExactly>& keys) const {
    std::array<float, kSweptExactly> centers;
    for (Index i = 0; i < count; ++i) centers[i] = bodies[i].center()[axis];
    for (Index i = 0; i < count; ++i) {
      const float own = centers[i];
      std::size_t rank = 0;
      for (Index j = 0; j < i; ++j) rank += centers[j] <= own ? 1 : 0;
      for (Index j = i + 1; j < count; ++j) rank += centers[j] < own ? 1 : 0;
      order[rank] = i, keys[rank] = own;
    }
  }

  Choice sweep(const Work& work, bool by_length) {
    const Index count = work.end - work.begin;
    const Body* bodies = &at(work.begin);
    Choice best;
    std::array<float, kSweptExactly> right, keys;
    for (int axis = 0; axis < layout_.dim; ++axis) {
      if (!(work.centers.low[axis] < work.centers.high[axis])) continue;
      Order order;
      sort_along(axis, bodies, count, order, keys);
      Bounds bounds = Bounds::none();
      for (Index i = count - 1; i > 0; --i) {
        const Body& body = bodies[order[i]];
        bounds.take(body.low, body.high);
        right[i] = size(bounds, by_length) * static_cast<float>(count - i);
      }
      bounds = Bounds::none();
      const float before = best.cost;
      for (Index i = 1; i < count; ++i) {
        const Body& body = bodies[order[i - 1]];
        bounds.take(body.low, body.high);
        const float cost = size(bounds, by_length) * static_cast<float>(i) + right[i];
        if (cost < best.cost) best = {axis, i, keys[i], cost};
      }
      if (best.cost < before) best_order_ = order;
    }
    return best;
  }

  void take_swept(const Work& work) {
    std::array<Body, kSweptExactly> sorted;
    const Index count = work.end - work.begin;
    for (Index i = 0; i < count; ++i) sorted[i] = at(work.begin + best_order_[i]);
    std::copy(sorted.begin(), sorted.begin() + count, bodies_.begin() + work.begin);
  }

  // -- Many: bins
  // -------------------------------------------------------------------------------------------------------------

  /// In which bin twice a centre falls, along each axis. An axis along which all centres are one has one bin.
  struct Binning {
    Lanes low, scale;
    int bins;

    explicit Binning(const Work& work)
        : low(work.centers.low), bins(work.end - work.begin <= kFew ? kFewBins : kMostBins) {
      for (int i = 0; i < 4; ++i) {
        const float extent = i < 3 ? work.centers.high[i] - work.centers.low[i] : 0;
        // So that the last centre falls into the last bin, and none beyond for rounding.
        scale[i] = extent > tolerance::kSameCenter ? static_cast<float>(bins) * (1 - 0x1p-20f) / extent : 0;
      }
    }
    [[nodiscard]] SNUG_INLINE WholeLanes bins_of(const Lanes& center) const {
      const Lanes place = (center - low) * scale;
      return __builtin_convertvector(place, WholeLanes);
    }
  };

  using Bins = std::array<Bounds, kMostBins>;

  Choice bin(const Work& work, bool by_length) {
    std::array<std::array<Index, kMostBins>, 3> counts{};
    const Binning binning(work);
    const auto bins = static_cast<std::size_t>(binning.bins);
    for (auto& axis : bins_) std::fill(axis.begin(), axis.begin() + binning.bins, Bounds::none());
    const Index count_all = work.end - work.begin, stride = count_all > 2 * kSample ? count_all / kSample : 1;
    for (Index i = work.begin; i < work.end; i += stride) {
      const Body body = at(i);
      const WholeLanes place = binning.bins_of(body.center());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto b = static_cast<std::size_t>(place[axis]);
        bins_[axis][b].take(body.low, body.high);
        ++counts[axis][b];
      }
    }
    Choice best;
    for (int axis = 0; axis < layout_.dim; ++axis) {
      if (binning.scale[axis] == 0) continue;
      const Bins& of_axis = bins_[axis];
      const auto& count_of = counts[axis];
      std::array<float, kMostBins> right;
      Bounds bounds = Bounds::none();
      Index count = 0;
      for (std::size_t b = bins - 1; b > 0; --b) {
        bounds.take(of_axis[b].low, of_axis[b].high);
        count += count_of[b];
        right[b] = size(bounds, by_length) * static_cast<float>(count);
      }
      bounds = Bounds::none();
      count = 0;
      for (std::size_t b = 1; b < bins; ++b) {
        bounds.take(of_axis[b - 1].low, of_axis[b - 1].high);
        count += count_of[b - 1];
        const float cost = size(bounds, by_length) * static_cast<float>(count) + right[b];
        // A sample may have no body on one side: then the cost is not a number.
        if (cost < best.cost) best = {axis, count, static_cast<float>(b), cost};
      }
    }
    best.cost *= static_cast<float>(stride);
    return best;
  }

  /// By the choice of bin, whose position is still the number of a bin, the first on the right.
  void partition(const Work& work, Choice& choice) {
    const Binning binning(work);
    const int axis = choice.axis, border = static_cast<int>(choice.position);
    choice.position = work.centers.low[axis] + choice.position / binning.scale[axis];
    // It goes through a copy, for branches that are guessed wrong cost more: bodies of the left fill it from the front,
    // others from the back.
    const auto count = static_cast<std::size_t>(work.end - work.begin);
    std::size_t left = 0, right = count - 1;
    const float low = binning.low[axis], scale = binning.scale[axis];
    const Body* bodies = &at(work.begin);
    Body* copies = copies_.data();
    for (std::size_t i = 0; i < count; ++i) {
      const float center = bodies[i].low[axis] + bodies[i].high[axis];
      const std::size_t goes_left = static_cast<std::size_t>(static_cast<int>((center - low) * scale) < border);
      copies[right + (left - right) * goes_left] = bodies[i];
      left += goes_left, right -= 1 - goes_left;
    }
    choice.left = static_cast<Index>(left);
    take_back(work.begin, 0, left, halves_[0]);
    take_back(work.begin, left, count, halves_[1]);
    are_measured_ = true;
  }

  /// Copies, to where the bodies of a node begin, and measures the half that they are.
  SNUG_INLINE void take_back(Index to, std::size_t from, std::size_t end, Work& half) {
    Bounds bounds = Bounds::none(), centers = bounds;
    Body* bodies = &at(to);
    const Body* copies = copies_.data();
    for (std::size_t i = from; i < end; ++i) {
      const Body body = copies[i];
      bounds.take(body.low, body.high);
      centers.take(body.center(), body.center());
      bodies[i] = body;
    }
    half.bounds = bounds, half.centers = centers;
  }

  void list_bodies() {
    shape_.bodies.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) shape_.bodies[i] = bodies_[i].index();
    for (const ShapeNode& node : shape_.nodes)
      std::sort(shape_.bodies.begin() + (node.count > 0 ? node.first : 0),
                shape_.bodies.begin() + (node.count > 0 ? node.first + node.count : 0));
  }

  [[nodiscard]] SNUG_INLINE Body& at(Index i) { return bodies_[i]; }

  const Layout& layout_;
  SplitRule rule_;
  Index most_in_leaf_;
  TopDownFacts* facts_;
  std::vector<Body> bodies_, copies_;
  Shape shape_;
  std::array<Work, 2> halves_;
  bool are_measured_ = false;  // the halves
  Order best_order_{};         // of the choice of sweep
  std::array<Bins, 3> bins_;   // of the last bin
};

}  // namespace

Shape lay_out_top_down(const Layout& layout, SplitRule rule, Index most_in_leaf, TopDownFacts* facts) {
  return TopDown(layout, rule, most_in_leaf, facts).run();
}

}  // namespace snug::hierarchy
