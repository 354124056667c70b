// Spheres, capsules and lozenges against each other: the distance of their cores against the sum of the radii.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.5; E. Larsen, S. Gottschalk, M. Lin, D. Manocha, "Fast
// proximity queries with swept sphere volumes", 1999.
#pragma once

#include "geometry/capsule.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/sphere.hpp"
#include "query/distance_rectangles.hpp"
#include "query/overlap_result.hpp"
#include "query/power_of_two.hpp"

namespace snug::query {

/// A swept sphere's core as a corner with two edges, zero where it has none.
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

/// How many of a core's edges there are.
template <class Swept>
inline constexpr int kCoreDim = 0;
template <class Scalar, int Dim>
inline constexpr int kCoreDim<Capsule<Scalar, Dim>> = 1;
template <class Scalar, int Dim>
inline constexpr int kCoreDim<Lozenge<Scalar, Dim>> = 2;

/// Both cores in space, the first at its own corner, scaled by a power of two so that nothing is larger than 1.
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
    const Rectangle<Scalar> a = rectangle_a();
    const Rectangle<Scalar> b = rectangle_b();
    RectanglePair<Scalar> pair(a, b);
    // Beyond this, no rounding lets the distance itself be touching.
    const Scalar surely = touching() + kTouching;
    if (pair.least_square() > surely * surely) return true;
    return apart(pair.closest(touching() * touching()));
  }

  [[nodiscard]] OverlapResult<Scalar, Dim> result() const {
    const ClosestPoints<Scalar> points = closest();
    OverlapResult<Scalar, Dim> result{.overlap = !apart(points), .distance = Scalar(0), .tests = points.tests};
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

  [[nodiscard]] Scalar touching() const { return radii_ + kTouching; }
  [[nodiscard]] bool apart(const ClosestPoints<Scalar>& points) const { return points.square > touching() * touching(); }

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
[[nodiscard]] SweptPair<A<Scalar, Dim>, B<Scalar, Dim>, Scalar, Dim> swept_pair(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b) {
  return {a, b};
}

}  // namespace snug::query
