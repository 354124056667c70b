// Overlap of axis-aligned boxes in three forms, and of k-DOPs.
#include <algorithm>

#include "fit/kdop/kdop_fit.hpp"
#include "geometry/point_set.hpp"
#include "number/dyadic.hpp"
#include "write/make.hpp"

namespace snug::write {
namespace boxes {
namespace {

// ---- axis-aligned boxes ------------------------------------------------------------------------------------------

enum BoxKind { kRandom, kTouching, kInside, kOneAxis, kFlat, kTiny, kFar };
constexpr std::array kBoxKinds{
    Kind{"random", "random boxes"},
    Kind{"touching", "boxes that only touch, or almost"},
    Kind{"inside", "boxes of which one contains the other, or does along two axes"},
    Kind{"one axis", "boxes that are apart along one axis alone"},
    Kind{"flat", "boxes without a width, down to single points"},
    Kind{"tiny", "very small boxes"},
    Kind{"far", "boxes far from the origin"},
};

using BoxPair = std::array<Intervals, 3>;  // one an axis

/// One axis in a relation, the others crossing.
BoxPair one_in(Cases& cases, Relation relation) {
  const std::uint32_t chosen = cases.random.below(3);
  BoxPair pair;
  for (std::uint32_t i = 0; i < 3; ++i) pair[i] = related(cases, i == chosen ? relation : Relation::kCrossing);
  return pair;
}

BoxPair flat_pair(Cases& cases, bool overlaps) {
  BoxPair pair = one_in(cases, overlaps ? Relation::kTouching : Relation::kApart);
  for (auto& [a, b] : pair) {
    if (cases.coin() || cases.coin()) continue;
    const bool apart = a.high < b.low || b.high < a.low;
    if (apart) b.high = b.low;
    else b.low = b.high = a.high;  // on the boundary
    if (cases.coin()) a.low = a.high;
  }
  return pair;
}

BoxPair box_pair(Cases& cases, int kind, bool overlaps) {
  if (kind == kTouching) return one_in(cases, overlaps ? Relation::kTouching : Relation::kAlmost);
  if (kind == kFlat) return flat_pair(cases, overlaps);
  if (kind == kOneAxis) return one_in(cases, overlaps ? Relation::kCrossing : Relation::kApart);
  BoxPair pair;
  if (kind == kInside) {
    for (Intervals& one : pair) one = related(cases, Relation::kWithin);
    if (!overlaps) pair[cases.random.below(3)] = related(cases, Relation::kApart);
    return pair;
  }
  for (Intervals& one : pair)
    one = related(cases, cases.random.below(4) == 0 ? Relation::kWithin : Relation::kCrossing);
  if (overlaps) return pair;
  const std::uint32_t gaps = 1 + cases.random.below(7);  // a bit for each axis that has one
  for (std::size_t i = 0; i < 3; ++i)
    if ((gaps >> i & 1) != 0) pair[i] = related(cases, Relation::kApart);
  return pair;
}

/// form: what the box from low to high is stored as, two numbers an axis.
using Form = std::array<double, 2> (*)(double low, double high);

/// Moves the place where the boxes touch to 0, along each axis. The second box has −0 there.
void touch_at_zero(BoxPair& pair) {
  for (auto& [a, b] : pair) {
    const double at = a.high == b.low ? a.high : b.high == a.low ? a.low : 0;
    for (double* end : {&a.low, &a.high, &b.low, &b.high}) *end -= at;
    for (double* end : {&b.low, &b.high})
      if (*end == 0) *end = -0.0;
  }
}

template <Form form>
void make_boxes(Cases& cases) {
  each_kind(kBoxKinds, [&](int kind, int i) {
    BoxPair pair = box_pair(cases, kind, i % 2 == 0);
    if (kind == kTouching && cases.coin()) touch_at_zero(pair);
    const Scale scale = kind == kTiny ? kTinyScale : kind == kFar ? kFarScale : kPlain;
    const bool swapped = cases.coin();
    Numbers input;
    for (std::size_t box = 0; box < 2; ++box)
      for (std::size_t part = 0; part < 2; ++part)
        for (const Intervals& intervals : pair) {
          const auto [low, high] = intervals[swapped ? 1 - box : box];
          put(input, form(scale(low), scale(high))[part]);
        }
    cases.add(kind, std::move(input));
  });
}

std::array<double, 2> min_max(double low, double high) { return {low, high}; }
std::array<double, 2> min_widths(double low, double high) { return {low, high - low}; }
std::array<double, 2> center_radius(double low, double high) { return {(low + high) / 2, (high - low) / 2}; }

/// Returns the ends of the interval that two numbers stand for, without rounding.
using Ends = std::array<Dyadic, 2> (*)(double, double);
std::array<Dyadic, 2> ends_of_min_max(double a, double b) { return {a, b}; }
std::array<Dyadic, 2> ends_of_min_widths(double a, double b) { return {a, Dyadic(a) + b}; }
std::array<Dyadic, 2> ends_of_center_radius(double a, double b) { return {Dyadic(a) - b, Dyadic(a) + b}; }

template <Ends ends>
Numbers boxes_overlap(const Numbers& input) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [a_low, a_high] = ends(input[i], input[i + 3]);
    const auto [b_low, b_high] = ends(input[i + 6], input[i + 9]);
    if (a_high < b_low || b_high < a_low) return {0};
  }
  return {1};
}

bool are_min_max(const Numbers& input) {
  for (std::size_t i = 0; i < 3; ++i)
    if (input[i] > input[i + 3] || input[i + 6] > input[i + 9]) return false;
  return true;
}
bool are_sizes(const Numbers& input) {
  for (std::size_t i = 3; i < 6; ++i)
    if (input[i] < 0 || input[i + 6] < 0) return false;
  return true;
}

// ---- k-DOPs ------------------------------------------------------------------------------------------------------

constexpr int kK = 14, kSlabs = kK / 2;
enum KdopKind { kAnyKdops, kKdopsTouching, kDiagonal, kKdopsInside, kKdopsTiny, kKdopsFar };
constexpr std::array kKdopKinds{
    Kind{"random", "random k-DOPs"},
    Kind{"touching", "k-DOPs that only touch, or almost"},
    Kind{"diagonal", "k-DOPs that are apart along a diagonal alone"},
    Kind{"inside", "k-DOPs of which one contains the other"},
    Kind{"tiny", "very small k-DOPs"},
    Kind{"far", "k-DOPs far from the origin"},
};

using Slabs = Kdop<double, 3>;

/// The slabs around four points with whole coordinates.
Slabs random_slabs(Cases& cases, int size) {
  std::vector<Vector3> points(4);
  for (Vector3& p : points) p = whole_point(cases, size);
  return fit::kdop_fit<double, 3>(PointSet<double, 3>::make(std::move(points))->span(), kK).volume;
}

/// The gaps along the axes; negative where the slabs overlap.
std::array<double, kSlabs> gaps(const Slabs& a, const Slabs& b) {
  std::array<double, kSlabs> all;
  for (std::size_t s = 0; s < kSlabs; ++s) all[s] = std::max(a.min[s] - b.max[s], b.min[s] - a.max[s]);
  return all;
}

bool is_of(int kind, const std::array<double, kSlabs>& gaps, bool overlaps) {
  const double most = *std::max_element(gaps.begin(), gaps.end());
  if (kind == kKdopsTouching) return most == 0;  // those that are almost touching are made of them
  if (kind == kDiagonal && !overlaps)
    return most > 0 && std::count_if(gaps.begin(), gaps.end(), [](double gap) { return gap >= 0; }) == 1 &&
           *std::max_element(gaps.begin(), gaps.begin() + 3) < 0;
  return overlaps ? most < 0 : most > 0;
}

Numbers kdops_input(const Slabs& a, const Slabs& b, const Scale& scale) {
  Numbers input;
  for (const Slabs& own : {a, b}) {
    const Slabs one = moved<double, 3>(own, Vector3::Constant(scale.offset));
    for (const auto* ends : {&one.min, &one.max})
      for (std::size_t s = 0; s < kSlabs; ++s) put(input, (*ends)[s] * scale.factor);
  }
  return input;
}

void make_kdops(Cases& cases) {
  each_kind(kKdopKinds, [&](int kind, int i) {
    const bool overlaps = i % 2 == 0;
    const Scale scale = kind == kKdopsTiny ? kTinyScale : kind == kKdopsFar ? kFarScale : kPlain;
    Slabs a, b;
    do {
      a = random_slabs(cases, kind == kKdopsInside ? 12 : 6);
      b = random_slabs(cases, kind == kKdopsInside ? 2 : 6);
      b = moved<double, 3>(b, whole_point(cases, overlaps ? 6 : 12));
    } while (!is_of(kind, gaps(a, b), overlaps));
    if (kind == kKdopsTouching && !overlaps) {
      const auto own = gaps(a, b);
      const auto s = static_cast<std::size_t>(std::max_element(own.begin(), own.end()) - own.begin());
      (a.min[s] == b.max[s] ? a.min[s] : b.min[s]) += kAlmost;
    }
    cases.add(kind, kdops_input(a, b, scale));
  });
}

Numbers kdops_overlap(const Numbers& input) {
  for (std::size_t s = 0; s < kSlabs; ++s)
    if (input[s] > input[s + 3 * kSlabs] || input[s + 2 * kSlabs] > input[s + kSlabs]) return {0};
  return {1};
}

/// Whether the slabs of each have a point in common.
bool are_kdops(const Numbers& input) {
  for (const std::size_t from : {std::size_t{0}, std::size_t{2 * kSlabs}}) {
    Slabs one{.k = kK};
    for (std::size_t s = 0; s < kSlabs; ++s) {
      one.min[s] = input[from + s], one.max[s] = input[from + s + kSlabs];
      if (one.min[s] > one.max[s]) return false;
    }
    if (kdop_vertices(one).empty()) return false;
  }
  return true;
}

constexpr std::array kFunctions{
    Function{"overlap-min-max", "overlap", "{a:{min:3n,max:3n},b:{min:3n,max:3n}}", "b", "volume_pair/min_max",
             kBoxKinds, make_boxes<min_max>, boxes_overlap<ends_of_min_max>, nullptr, are_min_max},
    Function{"overlap-min-widths", "overlap", "{a:{min:3n,widths:3n},b:{min:3n,widths:3n}}", "b",
             "volume_pair/min_widths", kBoxKinds, make_boxes<min_widths>, boxes_overlap<ends_of_min_widths>, nullptr,
             are_sizes},
    Function{"overlap-center-radius", "overlap", "{a:{center:3n,half_extents:3n},b:{center:3n,half_extents:3n}}", "b",
             "volume_pair/center_radius", kBoxKinds, make_boxes<center_radius>, boxes_overlap<ends_of_center_radius>,
             nullptr, are_sizes},
    Function{"overlap-kdop", "overlap", "{a:{min:7n,max:7n},b:{min:7n,max:7n}}", "b", "volume_pair/slabs", kKdopKinds,
             make_kdops, kdops_overlap, nullptr, are_kdops},
};

}  // namespace
}  // namespace boxes

std::span<const Function> box_functions() { return boxes::kFunctions; }

}  // namespace snug::write
