// The sphere around the centre of the axis-aligned box.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, section 4.3.
#pragma once

#include <array>
#include <string_view>

#include "fit/sphere/extremes.hpp"
#include "fit/sphere/sphere_steps.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 4> kAabbCenterPseudocode{
    "box ← least and greatest coordinates",
    "c ← centre of the box",
    "r ← distance from c to the farthest point",
    "return c and r",
};

/// The sphere around the centre of the points' axis-aligned bounding box.
/// points: n >= 1 finite points, scene units. O(n) time: two passes.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> aabb_center(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = SphereStep<Scalar, Dim>;
  const ExtremesFound<Scalar, Dim> extremes = extreme_points(points, observe);
  observe(Step{0, false, {}, extremes});

  Vector<Scalar, Dim> least, greatest;
  for (int axis = 0; axis < Dim; ++axis) {
    least[axis] = points[extremes.least[axis]][axis];
    greatest[axis] = points[extremes.greatest[axis]][axis];
  }
  Sphere<Scalar, Dim> ball;
  ball.center = (least + greatest) / 2;
  observe(Step{1, false, {}, MidpointFound<Scalar, Dim>{least, greatest, ball.center}});

  const FarthestPoints<Scalar> far = farthest_points(ball.center, points);
  const Index farthest = far.overall.point;
  ball.radius = enclosing_radius(ball.center, points, far);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDistanceTests, points.size());
  observe.count(Operation::kSquareRoots, 1);
  observe(Step{2, true, ball, FarthestFound{farthest, static_cast<double>(ball.radius)}});
  observe(Step{3, true, ball, Finished{{farthest}}});
  return {ball, {farthest}};
}

}  // namespace snug::fit
