// Ritter's growing pass, which three algorithms share.
#pragma once

#include <algorithm>
#include <cmath>

#include "fit/sphere/sphere_steps.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// Grows the ball to a point, if the point is outside: the new ball passes through the point on one side and touches
/// the back of the old ball on the other. Returns whether it grew.
/// Source: J. Ritter, "An efficient bounding sphere", Graphics Gems, 1990.
template <class Scalar, int Dim, class Observer>
bool grow_to_hold(Sphere<Scalar, Dim>& ball, const Vector<Scalar, Dim>& point, Index index, int line,
                  Observer& observe) {
  const Vector<Scalar, Dim> to_point = point - ball.center;
  const Scalar square = to_point.squaredNorm();
  const bool outside = square > ball.radius * ball.radius;
  if constexpr (kWatched<Observer>) {
    observe.count(Operation::kPointsTouched, 1);
    observe.count(Operation::kDistanceTests, 1);
    observe(SphereStep<Scalar, Dim>{line, true, ball,
                                    PointExamined{index, std::sqrt(static_cast<double>(square)), outside}});
  }
  if (!outside) return false;

  const Sphere<Scalar, Dim> before = ball;
  const Scalar distance = std::sqrt(square);
  const Scalar radius = (ball.radius + distance) / 2;
  ball.center += to_point * ((radius - ball.radius) / distance);
  ball.radius = radius;
  if constexpr (kWatched<Observer>) {
    observe.count(Operation::kSquareRoots, 1);
    observe(SphereStep<Scalar, Dim>{line + 1, true, ball, BallGrown<Scalar, Dim>{index, before}});
  }
  return true;
}

/// Ends a growing algorithm: widens the radius if rounding left a point outside. The farthest point joins the support
/// set: where two points touch the ball, the pass may have ended with either, and rounding decides which is farther.
template <class Scalar, int Dim, class Observer>
Fit<Sphere<Scalar, Dim>> finish_grown(Sphere<Scalar, Dim> ball, Support support, PointSpan<Scalar, Dim> points,
                                      int line, Observer& observe) {
  using Step = SphereStep<Scalar, Dim>;
  const FarthestPoints<Scalar> far = farthest_points(ball.center, points);
  const Scalar enclosing = enclosing_radius(ball.center, points, far);
  const bool widened = enclosing > ball.radius;
  ball.radius = std::max(ball.radius, enclosing);
  if (!support.contains(far.overall.point)) support.add(far.overall.point);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDistanceTests, points.size());
  observe(Step{line, true, ball, RadiusChecked{far.overall.point, widened}});
  observe(Step{line + 1, true, ball, Finished{support.list()}});
  return {ball, support};
}

}  // namespace snug::fit
