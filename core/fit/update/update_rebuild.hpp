// Updates an axis-aligned box of a rotated body by a new fit to all of its points.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.2.4.
#pragma once

#include <array>
#include <string_view>

#include "fit/aabb/aabb_min_max.hpp"
#include "fit/update/update.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 4> kUpdateRebuildPseudocode{
    "for each point p",
    "  transform p to the world frame",
    "  if p outside: widen the box to p",
    "return box",
};

/// The tightest box, from every point: the most expensive update, and the one that the others are measured against.
/// O(n) time. points: in the local frame.
template <class Scalar, int Dim, StepObserver<UpdateStep<Aabb<Scalar, Dim>>> Observer = Ignore>
Updated<Aabb<Scalar, Dim>> update_rebuild(PointSpan<Scalar, Dim> points, const Pose<Scalar, Dim>& pose,
                                          Observer&& observe = {}) {
  using Step = UpdateStep<Aabb<Scalar, Dim>>;
  const Vector<Scalar, Dim> first = placed(pose, points[0]);
  Aabb<Scalar, Dim> box{first, first};
  ExtremesFound<Scalar, Dim> extremes;
  observe(Step{2, true, box, BoxWidened{0}});
  for (Index i = 1; i < points.size(); ++i)
    if (widen_to_hold(box, extremes, placed(pose, points[i]), i)) observe(Step{2, true, box, BoxWidened{i}});
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDotProducts, Dim * std::int64_t{points.size()});
  observe.count(Operation::kComparisons, 2 * Dim * (std::int64_t{points.size()} - 1));
  observe(Step{3, true, box, Finished{support_of(extremes)}});
  return {box};
}

}  // namespace snug::fit
