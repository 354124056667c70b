// Tests spheres, capsules and lozenges against each other: the cores' distance against the sum of the radii.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.5; E. Larsen, S. Gottschalk, M. Lin, D. Manocha, "Fast
// proximity queries with swept sphere volumes", 1999.
#pragma once

#include <optional>

#include "geometry/capsule.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/sphere.hpp"
#include "number/power_of_two.hpp"
#include "query/distance_rectangles.hpp"
#include "query/overlap_result.hpp"
#include "query/overlap_steps.hpp"
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
    if constexpr (kCoreDim<B> < 2) return apart(closest());
    if (const auto known = at_a_glance()) return *known;
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

  /// Decides most pairs without a rectangle's axes: by the spheres around both cores, by two points that are each
  /// projected onto the other core in turn, or by the plane perpendicular to the line between them. None if that leaves
  /// the answer within the error bound.
  [[nodiscard]] std::optional<bool> at_a_glance() const {
    const Space middle =
        between_ + ((b_edges_[0] + b_edges_[1]) - (a_edges_[0] + a_edges_[1])) / 2;  // b's core from a's
    const Scalar beyond = touching() + 2 * kTouching;
    const Scalar reach = diagonal(a_edges_) / 2 + diagonal(b_edges_) / 2 + beyond;
    if (middle.squaredNorm() > reach * reach) return true;

    const std::array<Scalar, 2> shares_a = shares(a_edges_), shares_b = shares(b_edges_);
    const Scalar within = std::max(radii_ - 2 * kTouching, Scalar(0));
    Space on_b = middle, way;
    for (int turn = 0; turn < 2; ++turn) {
      const Space on_a = nearest(on_b, a_edges_, shares_a);
      on_b = middle + nearest(on_a - middle, b_edges_, shares_b);
      way = on_b - on_a;
      if (way.squaredNorm() <= within * within && within > 0) return false;
    }
    const Scalar gap = middle.dot(way) - (span(a_edges_, way) + span(b_edges_, way)) / 2;
    if (gap > 0 && gap * gap > beyond * beyond * way.squaredNorm()) return true;
    return std::nullopt;
  }

  /// The factors that turn a projection onto each edge into a fraction of the edge; 0 if the edge counts as a point.
  [[nodiscard]] static std::array<Scalar, 2> shares(const std::array<Space, 2>& edges) {
    const std::array squares{edges[0].squaredNorm(), edges[1].squaredNorm()};
    return {vanishes(squares[0]) ? 0 : 1 / squares[0], vanishes(squares[1]) ? 0 : 1 / squares[1]};
  }

  /// The point of a core around the origin nearest to p, up to edges that are not exactly perpendicular.
  [[nodiscard]] static Space nearest(const Space& p, const std::array<Space, 2>& edges,
                                     const std::array<Scalar, 2>& shares) {
    const auto part = [&](std::size_t i) { return std::clamp(p.dot(edges[i]) * shares[i], Scalar(-0.5), Scalar(0.5)); };
    return part(0) * edges[0] + part(1) * edges[1];
  }

  /// The extent of a core along a direction, times the direction's length.
  [[nodiscard]] static Scalar span(const std::array<Space, 2>& edges, const Space& way) {
    return std::abs(edges[0].dot(way)) + std::abs(edges[1].dot(way));
  }

  /// The length of the longer diagonal.
  [[nodiscard]] static Scalar diagonal(const std::array<Space, 2>& edges) {
    return std::sqrt(edges[0].squaredNorm() + edges[1].squaredNorm() + 2 * std::abs(edges[0].dot(edges[1])));
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

}  // namespace snug::query
