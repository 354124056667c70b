#include "fit/obb/obb_edge_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace snug::fit {
namespace {

using Point = Vector<double, 3>;

/// Longer stretches are soon halved, and not worth a second look.
constexpr double kShortTurn = 0x1p-16;

Point mix(const Point& a, const Point& b, double share) { return (1 - share) * a + share * b; }
double mix(double a, double b, double share) { return (1 - share) * a + share * b; }

/// Bernstein coefficients of a product of two linear or two quadratic polynomials, from those of the factors.
using Quadratic = std::array<double, 3>;
using Quartic = std::array<double, 5>;

Quadratic product(double p0, double p1, double q0, double q1) { return {p0 * q0, (p0 * q1 + p1 * q0) / 2, p1 * q1}; }

Quartic product(const Quadratic& p, const Quadratic& q) {
  return {p[0] * q[0], (p[0] * q[1] + p[1] * q[0]) / 2, (p[0] * q[2] + 4 * (p[1] * q[1]) + p[2] * q[0]) / 6,
          (p[1] * q[2] + p[2] * q[1]) / 2, p[2] * q[2]};
}

/// The zero of a linear function from p at 0 to q at 1; 0 if it has none in between.
double root(double p, double q) { return (p < 0) == (q < 0) ? 0 : p / (p - q); }

}  // namespace

EdgePairSearch::EdgePairSearch(const HullSolid& solid, const Matrix<double, 3>& start)
    : solid_(solid), measure_(std::numeric_limits<double>::infinity()), with_a_(solid.normals().size()),
      with_b_(solid.normals().size()) {
  for (const NormalArc& arc : solid.arcs())
    ends_.push_back({static_cast<std::size_t>(arc.from), static_cast<std::size_t>(arc.to)});
  take(start);
}

bool EdgePairSearch::take(const Matrix<double, 3>& axes) {
  const LocalBox<3> box(axes, solid_.vertices());
  const Point lengths = box.greatest - box.least;
  if (!(lengths.prod() < measure_)) return false;
  axes_ = axes;
  measure_ = lengths.prod();
  to_beat_ = (lengths.array() - tolerance::kBoxProof * solid_.size()).cwiseMax(0).prod();
  return true;
}

template <class Count>
PairTally EdgePairSearch::search(Index edge, Count& count) {
  PairTally tally;
  const std::vector<NormalArc>& arcs = solid_.arcs();
  const auto by_edge = [](const NormalArc& arc, Index e) { return arc.edge < e; };
  const auto begin = std::lower_bound(arcs.begin(), arcs.end(), edge, by_edge);
  const auto end = std::lower_bound(begin, arcs.end(), edge + 1, by_edge);
  for (auto first = begin; first != end; ++first) {
    for (std::size_t i = 0; i < solid_.normals().size(); ++i) {
      with_a_[i] = first->a.dot(solid_.normals()[i]);
      with_b_[i] = first->b.dot(solid_.normals()[i]);
    }
    const std::size_t later = end - arcs.begin();
    count.count(Operation::kDotProducts, 2 * std::ssize(solid_.normals()));
    count.count(Operation::kComparisons, 4 * static_cast<std::int64_t>(arcs.size() - later));  // signs at the four ends
    for (std::size_t second = later; second < arcs.size(); ++second) {
      const auto [from, to] = ends_[second];
      const double aa = with_a_[from], ab = with_a_[to], ba = with_b_[from], bb = with_b_[to];
      // The dot product of two normals is bilinear in their positions on the arcs: either it is 0 somewhere, or it has
      // the same sign at all four ends.
      if (std::min(std::min(aa, ab), std::min(ba, bb)) > 0 || std::max(std::max(aa, ab), std::max(ba, bb)) < 0)
        continue;
      ++tally.pairs;
      search_pair({*first, arcs[second], aa, ab, ba, bb}, tally, count);
    }
  }
  return tally;
}

// A normal of the first arc is perpendicular to some normal of the second if its dot products with the second's ends
// have opposite signs.
template <class Count>
void EdgePairSearch::search_pair(const Pair& pair, PairTally& tally, Count& count) {
  std::array<double, 4> breaks{0, root(pair.aa, pair.ba), root(pair.ab, pair.bb), 1};
  if (breaks[1] > breaks[2]) std::swap(breaks[1], breaks[2]);
  bool all_ruled_out = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(breaks[i] < breaks[i + 1])) continue;
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    const double with_a = mix(pair.aa, pair.ba, middle), with_b = mix(pair.ab, pair.bb, middle);
    count.count(Operation::kComparisons, 2);
    if ((with_a > 0 && with_b > 0) || (with_a < 0 && with_b < 0)) continue;
    const Stretch stretch{pair.at_first(breaks[i]), pair.at_first(breaks[i + 1])};
    count.count(Operation::kPointsTouched, 2);
    if (all_larger(pair.by_first(stretch), nearby_spans(pair, middle), count)) continue;
    all_ruled_out = false;
    halve(pair, stretch, tally, count);
  }
  if (all_ruled_out) ++tally.ruled_out;
}

/// Where the dot product is a product of a function of t and one of s, or nearly so, the curve is two lines that cross:
/// there rounding may put a place beside its stretch, which would never become shorter.
EdgePairSearch::Place EdgePairSearch::within(const Stretch& stretch, const Place& place) {
  const auto between = [](double from, double to, double at) {
    return std::clamp(at, std::min(from, to), std::max(from, to));
  };
  return {between(stretch.from.t, stretch.to.t, place.t), between(stretch.from.s, stretch.to.s, place.s)};
}

template <class Count>
void EdgePairSearch::halve(const Pair& pair, const Stretch& whole, PairTally& tally, Count& count) {
  open_.assign({whole});
  while (!open_.empty()) {
    const Stretch stretch = open_.back();
    open_.pop_back();
    // The position of the faster normal is the parameter: the slower one's might not resolve the curve.
    const double first_turn = std::abs(stretch.to.t - stretch.from.t) * pair.first.angle;
    const double second_turn = std::abs(stretch.to.s - stretch.from.s) * pair.second.angle;
    const bool by_first = first_turn >= second_turn;
    const Place middle = within(stretch, by_first ? pair.at_first((stretch.from.t + stretch.to.t) / 2)
                                                  : pair.at_second((stretch.from.s + stretch.to.s) / 2));
    const Point first = mix(pair.first.a, pair.first.b, middle.t).normalized();
    const Point second = mix(pair.second.a, pair.second.b, middle.s).normalized();
    const Spans spans = spans_at(pair, first, second, count);
    const double measure = spans.first.dot(first) * spans.second.dot(second) * spans.third.dot(first.cross(second));
    count.count(Operation::kSquareRoots, 2);
    count.count(Operation::kDotProducts, 3);
    count.count(Operation::kComparisons, 1);
    if (measure < measure_) {
      count_box<3>(solid_.vertices().size(), count);
      if (take(frame(first, second))) tally.smaller_on = vertices_of(pair);
    }
    if (all_larger(by_first ? pair.by_first(stretch) : pair.by_second(stretch), spans, count)) continue;
    if (first_turn + second_turn <= kShortTurn && all_larger_around(pair, stretch, spans, count)) continue;
    if (first_turn + second_turn <= tolerance::kSameTurn) continue;
    ++tally.halvings;
    open_.push_back({middle, stretch.to});
    open_.push_back({stretch.from, middle});
  }
}

EdgePairSearch::Spans EdgePairSearch::nearby_spans(const Pair& pair, double t) const {
  const Ends at = pair.by_first({pair.at_first(t), pair.at_first(t)});
  const Point third = at.first[0].cross(at.second[0]);
  return {pair.first.thickness, pair.second.thickness, solid_.at(solid_.far(third)) - solid_.at(solid_.far(-third))};
}

template <class Count>
EdgePairSearch::Spans EdgePairSearch::spans_at(const Pair& pair, const Point& first, const Point& second,
                                               Count& count) const {
  const auto farthest = [&](const Point& direction) {
    return solid_.at(solid_.farthest(direction, solid_.far(direction), count));
  };
  const auto edge = [&](const NormalArc& arc) { return solid_.at(solid_.edges()[arc.edge][0]); };
  const Point third = first.cross(second);
  return {edge(pair.first) - farthest(-first), edge(pair.second) - farthest(-second),
          farthest(third) - farthest(-third)};
}

// Along its normals, the box is at least as long as the spans. With normals m and n, and their cross product as the
// third, (p . m) (q . n) (r . (m x n)) is the volume between the spans times |m|^2 |n|^2. Both are quartics in the
// parameter.
template <class Count>
bool EdgePairSearch::all_larger(const Ends& ends, const Spans& spans, Count& count) const {
  count.count(Operation::kComparisons, 1);
  if (!(to_beat_ > 0)) return true;
  const auto& [m, n] = ends;
  const double p0 = spans.first.dot(m[0]), p1 = spans.first.dot(m[1]);
  const double q0 = spans.second.dot(n[0]), q1 = spans.second.dot(n[1]);
  const Point across0 = spans.third.cross(m[0]), across1 = spans.third.cross(m[1]);
  const Quadratic third{across0.dot(n[0]), (across0.dot(n[1]) + across1.dot(n[0])) / 2, across1.dot(n[1])};
  count.count(Operation::kDotProducts, 8);
  count.count(Operation::kComparisons, 7);
  if (!(std::min({p0, p1, q0, q1, third[0], third[1], third[2]}) >= 0)) return false;
  const Quartic volume = product(product(p0, p1, q0, q1), third);
  const Quartic scale = product(Quadratic{m[0].squaredNorm(), m[0].dot(m[1]), m[1].squaredNorm()},
                                Quadratic{n[0].squaredNorm(), n[0].dot(n[1]), n[1].squaredNorm()});
  count.count(Operation::kDotProducts, 6);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    count.count(Operation::kComparisons, 1);
    if (!(volume[i] >= to_beat_ * scale[i])) return false;
  }
  return true;
}

// The same of any normals within the stretch, whether or not they are quite perpendicular: a quadratic in either
// parameter. It needs no place on the curve, which rounding moves by much where the curve is nearly two lines that
// cross.
template <class Count>
bool EdgePairSearch::all_larger_around(const Pair& pair, const Stretch& stretch, const Spans& spans,
                                       Count& count) const {
  count.count(Operation::kDotProducts, 14);
  count.count(Operation::kComparisons, 17);
  const std::array<Point, 2> m{mix(pair.first.a, pair.first.b, stretch.from.t),
                               mix(pair.first.a, pair.first.b, stretch.to.t)};
  const std::array<Point, 2> n{mix(pair.second.a, pair.second.b, stretch.from.s),
                               mix(pair.second.a, pair.second.b, stretch.to.s)};
  const double p0 = spans.first.dot(m[0]), p1 = spans.first.dot(m[1]);
  const double q0 = spans.second.dot(n[0]), q1 = spans.second.dot(n[1]);
  std::array<std::array<double, 2>, 2> third;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) third[i][j] = spans.third.cross(m[i]).dot(n[j]);
  if (!(std::min({p0, p1, q0, q1, third[0][0], third[0][1], third[1][0], third[1][1]}) >= 0)) return false;
  const Quadratic mm{m[0].squaredNorm(), m[0].dot(m[1]), m[1].squaredNorm()};
  const Quadratic nn{n[0].squaredNorm(), n[0].dot(n[1]), n[1].squaredNorm()};
  // Of p(t) third(t, s), by t, for both ends of s; then times q(s).
  const Quadratic at_from = product(p0, p1, third[0][0], third[1][0]),
                  at_to = product(p0, p1, third[0][1], third[1][1]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Quadratic volume = product(q0, q1, at_from[i], at_to[i]);
    for (std::size_t j = 0; j < 3; ++j)
      if (!(volume[j] >= to_beat_ * mm[i] * nn[j])) return false;
  }
  return true;
}

std::array<Index, 4> EdgePairSearch::vertices_of(const Pair& pair) const {
  const auto& e = solid_.edges()[pair.first.edge];
  const auto& f = solid_.edges()[pair.second.edge];
  return {e[0], e[1], f[0], f[1]};
}

// A normal m of one arc is perpendicular to the normal |m . b| a + |m . a| b of the other arc, which goes from a to b.
EdgePairSearch::Place EdgePairSearch::Pair::at_first(double t) const {
  const double with_a = std::abs(mix(aa, ba, t)), with_b = std::abs(mix(ab, bb, t));
  return {t, with_a + with_b > 0 ? with_a / (with_a + with_b) : 0};
}

EdgePairSearch::Place EdgePairSearch::Pair::at_second(double s) const {
  const double with_a = std::abs(mix(aa, ab, s)), with_b = std::abs(mix(ba, bb, s));
  return {with_a + with_b > 0 ? with_a / (with_a + with_b) : 0, s};
}

EdgePairSearch::Ends EdgePairSearch::Pair::by_first(const Stretch& stretch) const {
  Ends ends;
  for (std::size_t i = 0; i < 2; ++i) {
    const double t = i == 0 ? stretch.from.t : stretch.to.t;
    ends.first[i] = mix(first.a, first.b, t);
    ends.second[i] = std::abs(mix(ab, bb, t)) * second.a + std::abs(mix(aa, ba, t)) * second.b;
  }
  return ends;
}

EdgePairSearch::Ends EdgePairSearch::Pair::by_second(const Stretch& stretch) const {
  Ends ends;
  for (std::size_t i = 0; i < 2; ++i) {
    const double s = i == 0 ? stretch.from.s : stretch.to.s;
    ends.first[i] = std::abs(mix(ba, bb, s)) * first.a + std::abs(mix(aa, ab, s)) * first.b;
    ends.second[i] = mix(second.a, second.b, s);
  }
  return ends;
}

template PairTally EdgePairSearch::search(Index, Ignore&);
template PairTally EdgePairSearch::search(Index, PartCounter&);

}  // namespace snug::fit
