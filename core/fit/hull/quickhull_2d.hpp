// Quickhull in the plane: the point farthest from an edge splits it in two.
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", 1996; in the plane as
// W. F. Eddy, "A new convex hull algorithm for planar sets", 1977. Every decision is exact: each point taken is a
// vertex.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/hull/hull_steps.hpp"
#include "geometry/orientation.hpp"
#include "geometry/point_set.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 7> kQuickhull2Pseudocode{
    "edges ← a b and b a, a the leftmost point, b the rightmost",
    "give each point to the edge that it lies outside of",
    "while an edge a b has points outside",
    "  c ← the farthest of them",
    "  replace a b by a c and c b",
    "  give its points to these two; drop those inside a b c",
    "return the edges in their order",
};

/// How sides are decided: exactly. quickhull_naive.hpp has two others.
struct ExactSides {
  using Point = Vector<double, 2>;
  /// Whether p lies outside of the edge from a to b: on its right.
  static bool outside(const Point& a, const Point& b, const Point& p) { return orient2d(a, b, p) < 0; }
  /// Above 0 if q lies farther out than p, 0 if neither does.
  static int farther(const Point& a, const Point& b, const Point& p, const Point& q) { return -cross_sign(a, b, p, q); }
};

/// One run. At: returns the point of an index, as Vector<double, 2>. The steps are those of a hull in Scalar.
template <class Scalar, class At, class Observer, class Sides = ExactSides>
class Quickhull2 {
 public:
  Quickhull2(Index n, At at, Observer& observe) : n_(n), at_(at), observe_(observe) {}

  /// The hull's vertices, counter-clockwise from the leftmost (of several, the lowest); of coincident points, the
  /// first. Two vertices if all points lie on a line, one if they all coincide.
  std::vector<Index> run() {
    start();
    std::vector<Index> ring;
    while (!open_.empty()) {
      const Edge edge = open_.back();
      open_.pop_back();
      if (edge.begin == edge.end) ring.push_back(edge.a);
      else split(edge);
    }
    return ring;
  }

 private:
  using Step = HullStep<Scalar, 2>;
  using Point = Vector<double, 2>;
  using Place = std::vector<Index>::iterator;

  /// An edge of the hull so far, and the points outside of it.
  struct Edge {
    Index id;
    Index a, b;
    Place begin, end;
    [[nodiscard]] Index count() const { return static_cast<Index>(end - begin); }
  };

  [[nodiscard]] static bool left_of(const Point& p, const Point& q) {
    return p[0] < q[0] || (p[0] == q[0] && p[1] < q[1]);
  }

  void start() {
    Index a = 0, b = 0;
    for (Index i = 1; i < n_; ++i) {
      if (left_of(at_(i), at_(a))) a = i;
      if (left_of(at_(b), at_(i))) b = i;
    }
    observe_.count(Operation::kPointsTouched, n_);
    observe_.count(Operation::kComparisons, 2 * std::int64_t{n_});
    list_.resize(n_);
    std::iota(list_.begin(), list_.end(), Index{0});
    if (a == b) return open_.push_back({0, a, a, list_.begin(), list_.begin()});
    if constexpr (kWatched<Observer>) observe_(Step{0, false, {}, SimplexChosen{{a, b}, {a, b, b, a}}});
    share({kNoIndex, a, a, list_.begin(), list_.end()}, b, 0, 1, 1);
  }

  /// Distributes the points of an edge that is replaced by edges to and from c, and opens those two. On return the
  /// first is on top.
  void share(const Edge& edge, Index c, Index first_id, Index second_id, int line) {
    const Point from = at_(edge.a), middle = at_(c), to = at_(edge.b);
    // A point beyond both would lie farther out than c, which is the farthest.
    Place first_end = edge.begin, second_end = edge.begin;
    for (Place i = edge.begin; i != edge.end; ++i) {
      const Point p = at_(*i);
      if (Sides::outside(from, middle, p)) {
        std::swap(*second_end++, *i);
        std::swap(*first_end++, *(second_end - 1));
      } else if (Sides::outside(middle, to, p)) {
        std::swap(*second_end++, *i);
      }
    }
    const Edge first{first_id, edge.a, c, edge.begin, first_end}, second{second_id, c, edge.b, first_end, second_end};
    open_.push_back(second);
    open_.push_back(first);
    observe_.count(Operation::kPointsTouched, edge.count());
    observe_.count(Operation::kOrientationTests, 2 * std::int64_t{edge.count()} - first.count());
    if constexpr (kWatched<Observer>) {
      PointsAssigned assigned{{first_id, second_id}, {first.count(), second.count()}, {edge.begin, second_end}, {}, 0};
      for (Place i = second_end; i != edge.end; ++i)
        if (*i != edge.a && *i != c) assigned.inside.push_back(*i);
      assigned.dropped = static_cast<Index>(assigned.inside.size());
      observe_(Step{line, false, {}, std::move(assigned)});
    }
  }

  /// The farthest outside point; of several, the last on the way from a to b, which is a vertex for certain.
  [[nodiscard]] Index farthest(const Edge& edge) {
    const Point a = at_(edge.a), b = at_(edge.b);
    Index best = *edge.begin;
    for (Place i = edge.begin + 1; i != edge.end; ++i) {
      int farther = Sides::farther(a, b, at_(best), at_(*i));
      if (farther == 0) farther = dot_sign<2>(a, b, at_(best), at_(*i));
      if (farther > 0 || (farther == 0 && *i < best)) best = *i;
    }
    observe_.count(Operation::kPointsTouched, edge.count());
    observe_.count(Operation::kComparisons, edge.count() - 1);
    return best;
  }

  void split(const Edge& edge) {
    const Index c = farthest(edge);
    if constexpr (kWatched<Observer>)
      observe_(Step{3, false, {}, EyeChosen{c, edge.id, distance(edge, c), edge.count()}});
    const Index added = ++last_id_;
    if constexpr (kWatched<Observer>)
      observe_(Step{4, false, {}, EdgeSplit{edge.id, edge.a, edge.b, c, edge.id, added}});
    share(edge, c, edge.id, added, 5);
  }

  /// The distance from the edge's line, scene units.
  [[nodiscard]] double distance(const Edge& edge, Index c) {
    const Point along = at_(edge.b) - at_(edge.a), out = at_(c) - at_(edge.a);
    const Point unit = along / scaled_norm<double, 2>(along);
    return std::abs(unit[0] * out[1] - unit[1] * out[0]);
  }

  Index n_;
  At at_;
  Observer& observe_;
  std::vector<Index> list_;  // all points; each edge's outside ones are a part of it
  std::vector<Edge> open_;   // the edges still to be walked, in their order, the next one last
  Index last_id_ = 1;
};

/// The indices of the hull's vertices, counter-clockwise, of n >= 1 points in the plane: at(i) is a Vector<double, 2>
/// of finite coordinates.
template <class Scalar, class At, class Observer>
std::vector<Index> hull_ring(Index n, At at, Observer& observe) {
  return Quickhull2<Scalar, At, Observer>(n, at, observe).run();
}

/// The hull of points in the plane whose ring of vertices is known.
template <class Scalar, class Points>
ConvexHull<Scalar, 2> polygon_on(const Points& points, std::vector<Index> ring) {
  ConvexHull<Scalar, 2> hull;
  const auto n = static_cast<Index>(ring.size());
  hull.affine_dim = std::min(n - 1, Index{2});
  for (const Index i : ring) hull.vertices.push_back(points[i]);
  for (Index i = 0; i < n && n > 2; ++i) hull.facets.push_back({i, (i + 1) % n});
  hull.indices = std::move(ring);
  return hull;
}

/// The hull of any finite points in the plane, of which at least one: for those who have no PointSet, as projections.
template <class Scalar, class Count>
ConvexHull<Scalar, 2> quickhull_2d(std::span<const Vector<Scalar, 2>> points, Count& count) {
  const auto at = [points](Index i) -> Vector<double, 2> { return points[i].template cast<double>(); };
  return polygon_on<Scalar>(points, hull_ring<Scalar>(static_cast<Index>(points.size()), at, count));
}

template <class Scalar, class Sides = ExactSides, class Observer>
Fit<ConvexHull<Scalar, 2>> quickhull_2d(PointSpan<Scalar, 2> points, Observer& observe) {
  const auto at = [points](Index i) -> Vector<double, 2> { return points[i].template cast<double>(); };
  const std::vector<Index> ring = Quickhull2<Scalar, decltype(at), Observer, Sides>(points.size(), at, observe).run();
  const std::span<const Vector<Scalar, 2>> all(points.begin(), points.end());
  const ConvexHull<Scalar, 2> hull = polygon_on<Scalar>(all, ring);
  observe(HullStep<Scalar, 2>{6, true, hull, Finished{ring}});
  return {hull, ring};
}

}  // namespace snug::fit
