// Ritter's sphere: through two points that are far apart, and grown in one pass over all.
// Source: J. Ritter, "An efficient bounding sphere", Graphics Gems, 1990.
#pragma once

#include <array>
#include <string_view>

#include "fit/sphere/extremes.hpp"
#include "fit/sphere/grow.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kRitterPseudocode{
    "find the extreme points along each axis",  //
    "S ← farthest pair as diameter",
    "for each point p",
    "  if p lies outside S: grow S to p",
    "test all points, exactly",
    "return S",
};

/// The ball with two points as its diameter.
template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> ball_on_diameter(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
  const Vector<Scalar, Dim> half = (b - a) / 2;
  return {a + half, half.norm()};
}

/// Returns the pair of extreme points that is farthest apart; there is one pair per axis.
template <class Scalar, int Dim, class Observer>
PairChosen farthest_pair(const ExtremesFound<Scalar, Dim>& extremes, PointSpan<Scalar, Dim> points, Observer& observe) {
  PairChosen chosen;
  Scalar most = -1;
  for (int axis = 0; axis < Dim; ++axis) {
    const Index a = extremes.least[axis];
    const Index b = extremes.greatest[axis];
    const Scalar square = (points[b] - points[a]).squaredNorm();
    if (square > most) {
      most = square;
      chosen = {a, b, axis, std::sqrt(static_cast<double>(square))};
    }
  }
  observe.count(Operation::kDistanceTests, Dim);
  observe.count(Operation::kSquareRoots, 1);
  return chosen;
}

/// The growing pass over all points in their order, from a first ball. line: that of the pseudocode's loop; growing,
/// the check and the end are the three lines after it.
template <class Scalar, int Dim, class Observer>
Fit<Sphere<Scalar, Dim>> grow_over_all(Sphere<Scalar, Dim> ball, Support support, PointSpan<Scalar, Dim> points,
                                       int line, Observer& observe) {
  for (Index i = 0; i < points.size(); ++i)
    if (grow_to_hold(ball, points[i], i, line, observe)) support = {i};
  return finish_grown(ball, support, points, line + 2, observe);
}

/// Ritter's sphere: six extremes, the pair farthest apart, one growing pass.
/// points: n >= 1 finite points, scene units. O(n) time: his two passes, and one that tests the result exactly. Often
/// within 10 per cent of the smallest, but that is not guaranteed.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> ritter(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = SphereStep<Scalar, Dim>;
  const ExtremesFound<Scalar, Dim> extremes = extreme_points(points, observe);
  observe(Step{0, false, {}, extremes});
  const PairChosen pair = farthest_pair(extremes, points, observe);
  const Sphere<Scalar, Dim> ball = ball_on_diameter<Scalar, Dim>(points[pair.a], points[pair.b]);
  observe(Step{1, true, ball, pair});
  return grow_over_all(ball, {pair.a, pair.b}, points, 2, observe);
}

}  // namespace snug::fit
