// Updates an axis-aligned box of a rotated body that is large enough for every rotation: it only moves.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.2.3.
#pragma once

#include <array>
#include <string_view>

#include "fit/update/update.hpp"
#include "geometry/point_set.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kUpdateLoosePseudocode{
    "once: reach ← farthest point from the pivot",
    "box ← pivot − reach to pivot + reach",
    "return box",
};

/// Found once for a body: how far any point can reach from the pivot along any axis, in every orientation.
template <class Scalar>
struct LooseReach {
  Scalar reach = 0;
  Index farthest = kNoIndex;
};

/// points: in the local frame. One pass. A rotated coordinate is at most the point's distance times the length of the
/// rotation's row, 1 + kRotation, with three roundings: kLooseReach covers both, and its own rounding.
template <class Scalar, int Dim, StepObserver<UpdateStep<Aabb<Scalar, Dim>>> Observer = Ignore>
LooseReach<Scalar> loose_reach(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  const Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  const FarthestPoints<Scalar> far = farthest_points(center, points);
  const Scalar distance = enclosing_radius(center, points, far);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDistanceTests, points.size());
  constexpr Scalar kLeast = std::numeric_limits<Scalar>::denorm_min();
  const LooseReach<Scalar> found{distance * (1 + tolerance::kLooseReach<Scalar>)+4 * kLeast, far.overall.point};
  observe(UpdateStep<Aabb<Scalar, Dim>>{0, false, {}, ReachFound{found.farthest, static_cast<double>(found.reach)}});
  return found;
}

/// The box that contains the body in every orientation, moved to where the body is: the cheapest update and the
/// loosest. For a unit cube about its centre it is sqrt(3) wide, 5.2 times the volume. No rotation changes it.
template <class Scalar, int Dim, StepObserver<UpdateStep<Aabb<Scalar, Dim>>> Observer = Ignore>
Updated<Aabb<Scalar, Dim>> update_loose(const LooseReach<Scalar>& reach, const Pose<Scalar, Dim>& pose,
                                        Observer&& observe = {}) {
  using Step = UpdateStep<Aabb<Scalar, Dim>>;
  const Vector<Scalar, Dim> reaches = Vector<Scalar, Dim>::Constant(reach.reach);
  const Aabb<Scalar, Dim> box{pose.translation - reaches, pose.translation + reaches};
  observe(Step{1, true, box, CenterMoved{}});
  observe(Step{2, true, box, Finished{{reach.farthest}}});
  return {box};
}

}  // namespace snug::fit
