// Tests spheres, capsules and lozenges against each other: the cores' distance against the sum of the radii.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.5; E. Larsen, S. Gottschalk, M. Lin, D. Manocha, "Fast
// proximity queries with swept sphere volumes", 1999.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "geometry/capsule.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/sphere.hpp"
#include "number/power_of_two.hpp"
#include "query/distance/distance_rectangles.hpp"
#include "query/overlap/overlap_result.hpp"
#include "query/overlap/overlap_steps.hpp"
#include "query/overlap/overlap_table.hpp"
#include "query/overlap/overlaps_spheres.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// A sphere-swept volume's core as a vertex with two edges, which are zero if it has none.
template <class Scalar, int Dim>
struct SweptCore {
  using Edges = std::array<Vector<Scalar, Dim>, 2>;
  Vector<Scalar, Dim> corner;
  Edges edges;
};

template <class Scalar, int Dim>
[[nodiscard]] SweptCore<Scalar, Dim> swept_core(const Sphere<Scalar, Dim>& sphere) {
  return {sphere.center, {Vector<Scalar, Dim>::Zero(), Vector<Scalar, Dim>::Zero()}};
}
template <class Scalar, int Dim>
[[nodiscard]] SweptCore<Scalar, Dim> swept_core(const Capsule<Scalar, Dim>& capsule) {
  return {capsule.a, {capsule.b - capsule.a, Vector<Scalar, Dim>::Zero()}};
}
template <class Scalar, int Dim>
[[nodiscard]] SweptCore<Scalar, Dim> swept_core(const Lozenge<Scalar, Dim>& lozenge) {
  return {lozenge.origin, lozenge.edges};
}

/// How many edges a core has.
template <class Swept>
inline constexpr int kCoreDim = 0;
template <class Scalar, int Dim>
inline constexpr int kCoreDim<Capsule<Scalar, Dim>> = 1;
template <class Scalar, int Dim>
inline constexpr int kCoreDim<Lozenge<Scalar, Dim>> = 2;

/// The squared distance of two cores, and the sum of that and all squared edges (see tolerance::kDistanceFilter). An
/// edge whose square is no normal number counts as any of its points.
template <class Scalar>
struct CoreDistance {
  Scalar square, sizes;
};

/// Where along an edge, as a part of its length; its start where that is undefined.
template <class Scalar>
[[nodiscard]] Scalar part_of_edge(Scalar along, Scalar square) {
  return square > 0 ? std::min(std::max(along / square, Scalar(0)), Scalar(1)) : Scalar(0);
}

template <class Scalar, int Dim>
[[nodiscard]] CoreDistance<Scalar> core_distance(const Sphere<Scalar, Dim>& sphere,
                                                 const Capsule<Scalar, Dim>& capsule) {
  const Vector<Scalar, Dim> edge = capsule.b - capsule.a, from_a = sphere.center - capsule.a;
  const Scalar along = from_a.dot(edge), edge_square = edge.squaredNorm();
  Scalar square;
  if (along <= 0) square = from_a.squaredNorm();
  else if (along >= edge_square) square = (sphere.center - capsule.b).squaredNorm();
  else square = from_a.squaredNorm() - along * (along / edge_square);
  return {square, square + edge_square};
}

template <class Scalar, int Dim>
[[nodiscard]] CoreDistance<Scalar> core_distance(const Sphere<Scalar, Dim>& sphere,
                                                 const Lozenge<Scalar, Dim>& lozenge) {
  const Vector<Scalar, Dim> from_origin = sphere.center - lozenge.origin;
  const Scalar u = lozenge.edges[0].squaredNorm(), v = lozenge.edges[1].squaredNorm();
  const Scalar s = part_of_edge(from_origin.dot(lozenge.edges[0]), u);
  const Scalar t = part_of_edge(from_origin.dot(lozenge.edges[1]), v);
  const Vector<Scalar, Dim> way = from_origin - s * lozenge.edges[0] - t * lozenge.edges[1];
  const Scalar square = way.squaredNorm();
  return {square, square + u + v};
}

/// Nearly parallel segments leave s as good as undefined, but their distance then hardly depends on it.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, 5.1.9, with both sides of s divided by v · v: a product of
/// four lengths would soon overflow or underflow.
template <class Scalar, int Dim>
[[nodiscard]] CoreDistance<Scalar> core_distance(const Capsule<Scalar, Dim>& a, const Capsule<Scalar, Dim>& b) {
  const Vector<Scalar, Dim> u = a.b - a.a, v = b.b - b.a, between = b.a - a.a;
  const Scalar uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), ub = u.dot(between), vb = v.dot(between);
  const Scalar inverse = vv >= std::numeric_limits<Scalar>::min() ? 1 / vv : Scalar(0), share = uv * inverse;
  Scalar s = part_of_edge(ub - share * vb, uu - share * uv);
  const Scalar along_v = uv * s - vb;
  Scalar t = along_v * inverse;
  if (along_v <= 0) {
    t = 0;
    s = part_of_edge(ub, uu);
  } else if (along_v >= vv) {
    t = 1;
    s = part_of_edge(uv + ub, uu);
  }
  const Vector<Scalar, Dim> way = between + t * v - s * u;
  const Scalar square = way.squaredNorm();
  return {square, square + uu + vv};
}

/// The filter of capsules and lozenges against lozenges: decides most pairs without scaling and without a rectangle's
/// axes. Both answers are proven: by two points, one on each core, that are nearer than the radii together; or by a
/// direction along which the cores are farther apart than that.
template <class Scalar, int Dim>
class SweptFilter {
 public:
  SweptFilter(const SweptCore<Scalar, Dim>& a, const SweptCore<Scalar, Dim>& b, Scalar radii)
      : a_(a.edges), b_(b.edges), middle_(b.corner - a.corner + (b_[0] + b_[1] - (a_[0] + a_[1])) / 2),
        a_squares_{a_[0].squaredNorm(), a_[1].squaredNorm()}, b_squares_{b_[0].squaredNorm(), b_[1].squaredNorm()},
        radii_square_(radii * radii) {
    error_bound_ = tolerance::kDistanceFilter<Scalar> * (middle_.squaredNorm() + radii_square_ + a_squares_[0] +
                                                         a_squares_[1] + b_squares_[0] + b_squares_[1]);
  }

  /// None where the answer is within the error bound.
  [[nodiscard]] std::optional<bool> apart() const {
    if (separates(middle_)) return true;
    Way on_b = middle_, way;
    for (int turn = 0; turn < 2; ++turn) {
      const Way on_a = nearest_point(on_b, a_, a_squares_);
      on_b = middle_ + nearest_point(on_a - middle_, b_, b_squares_);
      way = on_b - on_a;
      if (way.squaredNorm() + error_bound_ + kLeast < radii_square_) return false;
    }
    if (separates(way)) return true;
    return std::nullopt;
  }

 private:
  using Way = Vector<Scalar, Dim>;
  using Edges = std::array<Way, 2>;
  static constexpr Scalar kLeast = std::numeric_limits<Scalar>::min();

  /// Whether the cores' projections on a direction are farther apart than the radii.
  [[nodiscard]] bool separates(const Way& way) const {
    const Scalar spans =
        std::abs(a_[0].dot(way)) + std::abs(a_[1].dot(way)) + std::abs(b_[0].dot(way)) + std::abs(b_[1].dot(way));
    const Scalar gap = middle_.dot(way) - spans / 2;
    return gap > 0 && gap * gap > (radii_square_ + error_bound_) * way.squaredNorm() + kLeast;
  }

  /// The point of a core around the origin nearest to p, up to edges that are not exactly perpendicular.
  [[nodiscard]] static Way nearest_point(const Way& p, const Edges& edges, const std::array<Scalar, 2>& squares) {
    Way point = Way::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      const Scalar half = squares[i] / 2;
      point += (part_of_edge(p.dot(edges[i]) + half, squares[i]) - Scalar(0.5)) * edges[i];
    }
    return point;
  }

  Edges a_, b_;
  Way middle_;  // b's centre from a's
  std::array<Scalar, 2> a_squares_, b_squares_;
  Scalar radii_square_, error_bound_;
};

/// Both cores in space, relative to the first one's vertex, scaled by a power of two so that nothing is larger than 1.
template <class A, class B, class Scalar, int Dim>
class SweptPair {
 public:
  static_assert(kCoreDim<A> <= kCoreDim<B>);

  SweptPair(const A& a, const B& b) {
    const SweptCore<Scalar, Dim> core_a = swept_core(a);
    const SweptCore<Scalar, Dim> core_b = swept_core(b);
    const Vector<Scalar, Dim> between = core_b.corner - core_a.corner;
    Scalar largest = std::max({a.radius, b.radius, between.cwiseAbs().maxCoeff()});
    for (const auto& edges : {core_a.edges, core_b.edges})
      for (const auto& edge : edges) largest = std::max(largest, edge.cwiseAbs().maxCoeff());
    unit_ = power_of_two_above(largest);
    a_edges_ = {scaled(core_a.edges[0]), scaled(core_a.edges[1])};
    b_edges_ = {scaled(core_b.edges[0]), scaled(core_b.edges[1])};
    between_ = scaled(between);
    radii_ = a.radius / unit_ + b.radius / unit_;
  }

  [[nodiscard]] bool apart() const {
    if constexpr (kCoreDim<A> == 0 || kCoreDim<B> < 2) return apart(closest());
    const Rectangle<Scalar> a = rectangle_a();
    const Rectangle<Scalar> b = rectangle_b();
    RectanglePair<Scalar> pair(a, b);
    // A computed distance above this is certainly not touching.
    const Scalar surely = touching() + kTouching;
    if (pair.least_square() > surely * surely) return true;
    return apart(pair.closest(touching() * touching()));
  }

  /// origin: the first core's vertex, for observers.
  template <class Observer>
  [[nodiscard]] OverlapResult<Scalar, Dim> result(const Vector<Scalar, Dim>& origin, Observer& observe) const {
    const ClosestPoints<Scalar> points = closest();
    OverlapResult<Scalar, Dim> result{.overlap = !apart(points), .distance = Scalar(0), .tests = points.tests};
    observe.count(Operation::kDistanceTests, points.tests);
    if constexpr (kWatched<Observer>) observe(OverlapStep{2, in_scene(points, origin)});
    if (result.overlap) return result;
    const Vector<Scalar, Dim> between = points.between.template head<Dim>();
    result.distance = (std::sqrt(points.square) - radii_) * unit_;
    result.separating_axis = {"closest_points", between / between.norm(), *result.distance};
    return result;
  }

 private:
  using Space = Vector<Scalar, 3>;
  static constexpr Scalar kTouching = tolerance::kTouching<Scalar>;

  [[nodiscard]] Space scaled(const Vector<Scalar, Dim>& v) const {
    Space result = Space::Zero();
    result.template head<Dim>() = v * (1 / unit_);
    return result;
  }

  [[nodiscard]] CoresCompared in_scene(const ClosestPoints<Scalar>& points, const Vector<Scalar, Dim>& origin) const {
    const auto unit = static_cast<double>(unit_);
    const Vector<double, 3> from = in_space<Scalar, Dim>(origin);
    return {from + points.a.template cast<double>() * unit,
            from + points.b.template cast<double>() * unit,
            std::sqrt(static_cast<double>(points.square)) * unit,
            static_cast<double>(radii_) * unit,
            apart(points),
            points.tests};
  }

  [[nodiscard]] Scalar touching() const { return radii_ + kTouching; }
  [[nodiscard]] bool apart(const ClosestPoints<Scalar>& points) const {
    return points.square > touching() * touching();
  }

  [[nodiscard]] Rectangle<Scalar> rectangle_a() const { return rectangle_of<Scalar>(Space::Zero(), a_edges_); }
  [[nodiscard]] Rectangle<Scalar> rectangle_b() const { return rectangle_of<Scalar>(between_, b_edges_); }

  [[nodiscard]] ClosestPoints<Scalar> closest() const {
    const Segment<Scalar> a{Space::Zero(), a_edges_[0]};
    const Segment<Scalar> b{between_, b_edges_[0]};
    if constexpr (kCoreDim<A> == 0 && kCoreDim<B> == 1) return closest_points(a.start, b);
    if constexpr (kCoreDim<A> == 0 && kCoreDim<B> == 2) return closest_points(a.start, rectangle_b());
    if constexpr (kCoreDim<A> == 1 && kCoreDim<B> == 1) return closest_points(a, b);
    return closest_points(rectangle_a(), rectangle_b());
  }

  Scalar unit_ = 1;  // a power of two, scene units
  std::array<Space, 2> a_edges_, b_edges_;
  Space between_;
  Scalar radii_ = 0;
};

template <template <class, int> class A, template <class, int> class B, class Scalar, int Dim>
[[nodiscard]] SweptPair<A<Scalar, Dim>, B<Scalar, Dim>, Scalar, Dim> swept_pair(const A<Scalar, Dim>& a,
                                                                                const B<Scalar, Dim>& b) {
  return {a, b};
}

template <class A, class B>
[[gnu::cold, gnu::noinline]] bool swept_overlap_closely(const A& a, const B& b) {
  if constexpr (std::is_same_v<A, B>)
    if (swapped(a, b)) return !swept_pair(b, a).apart();
  return !swept_pair(a, b).apart();
}

/// As for spheres and boxes (query/overlap/overlaps_spheres.hpp), a before b in the table's order.
template <template <class, int> class A, template <class, int> class B, class Scalar, int Dim>
requires requires(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b) {
  swept_core(a);
  swept_core(b);
}
[[nodiscard, gnu::flatten]] std::optional<bool> apart_filter(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b) {
  const Scalar radii = a.radius + b.radius;
  if constexpr (requires { core_distance(a, b); }) {
    const CoreDistance<Scalar> distance = core_distance(a, b);
    const Scalar square = radii * radii;
    // Two edges e that count as points may change d^2 by 4 d |e|, which is at most k d^2 / 4 + 16 e^2 / k.
    constexpr Scalar k = tolerance::kDistanceFilter<Scalar>, kShortEdges = std::numeric_limits<Scalar>::min() / k;
    return if_certain(distance.square - square, k * (distance.sizes + square) + 16 * kShortEdges);
  } else {
    return SweptFilter<Scalar, Dim>(swept_core(a), swept_core(b), radii).apart();
  }
}

/// The verdict of SweptPair.
template <class A, class B>
[[nodiscard, gnu::always_inline]] inline bool swept_overlap(const A& a, const B& b) {
  if (const auto apart = apart_filter(a, b)) [[likely]]
    return !*apart;
  return swept_overlap_closely(a, b);
}

}  // namespace snug::query
