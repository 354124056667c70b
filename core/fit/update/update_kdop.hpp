// What the updates of k-DOPs share: the three methods of AABBs, with more directions. (The fourth is in
// update_kdop_climb.hpp.)
// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.2 and 4.6.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "fit/update/update.hpp"
#include "fit/update/update_loose.hpp"
#include "geometry/kdop_project.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kUpdateKdopLoosePseudocode{
    "once: reach ← farthest point from the pivot",
    "bounds ← pivot · axis ± reach · |axis|",
    "return k-DOP",
};

inline constexpr std::array<std::string_view, 3> kUpdateKdopRebuildPseudocode{
    "for each of the k / 2 axes",
    "  bounds ← extremes of all transformed points",
    "return k-DOP",
};

inline constexpr std::array<std::string_view, 3> kUpdateKdopRotatedPseudocode{
    "for each of the k / 2 axes",
    "  bounds ← extremes of the local k-DOP's transformed vertices",
    "return k-DOP",
};

/// The bounds of placed points along one axis, each exact but for one rounding outwards.
template <class Scalar, int Dim, class Points>
[[nodiscard]] std::pair<Scalar, Scalar> placed_bounds(const KdopAxis<Dim>& axis, const Points& points,
                                                      const Pose<Scalar, Dim>& pose) {
  std::pair<Scalar, Scalar> bounds{std::numeric_limits<Scalar>::infinity(), -std::numeric_limits<Scalar>::infinity()};
  for (const Vector<Scalar, Dim>& p : points) {
    const Vector<Scalar, Dim> at = placed(pose, p);
    bounds.first = std::min(bounds.first, project_down<Scalar, Dim>(axis, at));
    bounds.second = std::max(bounds.second, project_up<Scalar, Dim>(axis, at));
  }
  return bounds;
}

/// Sets each slab to what bounds_along(axis) says, moved out by error_bound. points: how many each slab examines.
template <class Scalar, int Dim, class Observer, class Bounds>
Updated<Kdop<Scalar, Dim>> update_slabs(int k, Scalar error_bound, std::int64_t points, Bounds bounds_along,
                                        Observer& observe) {
  using Step = UpdateStep<Kdop<Scalar, Dim>>;
  Kdop<Scalar, Dim> kdop{.k = k};
  const auto axes = kdop_axes<Dim>(k);
  for (std::size_t slab = 0; slab < axes.size(); ++slab) {
    const auto [least, greatest] = bounds_along(axes[slab]);
    kdop.min[slab] = least - error_bound;
    kdop.max[slab] = greatest + error_bound;
    observe.count(Operation::kPointsTouched, points);
    observe.count(Operation::kDotProducts, points * (Dim + 1));  // placed, then projected
    observe.count(Operation::kComparisons, 2 * points);
    if constexpr (kWatched<Observer>) {
      const bool has_volume = slab + 1 >= Dim;
      if (has_volume) imply_slabs(kdop, slab + 1);
      observe(Step{1, has_volume, kdop,
                   BoundsRotated{static_cast<int>(slab), static_cast<double>(kdop.min[slab]),
                                 static_cast<double>(kdop.max[slab])}});
    }
  }
  observe(Step{2, true, kdop, Finished{}});
  return {kdop};
}

/// The k-DOP that contains the body in every orientation, around the sphere about its pivot: no point is examined.
/// reach: of loose_reach. A projection of a placed point is off by at most 53u of the reach and 10u of the translation,
/// that of the pivot and the sums here included: twice kPlaced covers it.
template <class Scalar, int Dim, StepObserver<UpdateStep<Kdop<Scalar, Dim>>> Observer = Ignore>
Updated<Kdop<Scalar, Dim>> update_kdop_loose(Scalar reach, int k, const Pose<Scalar, Dim>& pose,
                                             Observer&& observe = {}) {
  const Scalar error_bound = 2 * tolerance::kPlaced<Scalar> * (reach + pose.translation.cwiseAbs().maxCoeff()) +
                             16 * std::numeric_limits<Scalar>::denorm_min();
  const auto around_pivot = [&](const KdopAxis<Dim>& axis) {
    Scalar square = 0;
    for (const int part : axis) square += static_cast<Scalar>(part * part);
    const Scalar middle = project<Scalar, Dim>(axis, pose.translation), half = reach * std::sqrt(square);
    return std::pair{middle - half, middle + half};
  };
  return update_slabs<Scalar, Dim>(k, error_bound, 0, around_pivot, observe);
}

/// The tightest k-DOP, from every point for every slab. O(k n) time. points: in the local frame.
template <class Scalar, int Dim, StepObserver<UpdateStep<Kdop<Scalar, Dim>>> Observer = Ignore>
Updated<Kdop<Scalar, Dim>> update_kdop_rebuild(PointSpan<Scalar, Dim> points, int k, const Pose<Scalar, Dim>& pose,
                                               Observer&& observe = {}) {
  return update_slabs<Scalar, Dim>(
      k, Scalar(0), points.size(),
      [&](const KdopAxis<Dim>& axis) { return placed_bounds<Scalar, Dim>(axis, points, pose); }, observe);
}

/// The k-DOP of the rotated local k-DOP: only its vertices are examined, however many points the body has.
/// vertices: of a k-DOP that contains the points in the local frame, each within 4 kKdopCorner of size.
/// size: at least every bound of it.
template <class Scalar, int Dim, StepObserver<UpdateStep<Kdop<Scalar, Dim>>> Observer = Ignore>
Updated<Kdop<Scalar, Dim>> update_kdop_rotated(std::span<const Vector<Scalar, Dim>> vertices, Scalar size, int k,
                                               const Pose<Scalar, Dim>& pose, Observer&& observe = {}) {
  const Scalar error_bound = 8 * tolerance::kPlaced<Scalar> * (size + pose.translation.cwiseAbs().maxCoeff()) +
                             16 * std::numeric_limits<Scalar>::denorm_min();
  return update_slabs<Scalar, Dim>(
      k, error_bound, std::ssize(vertices),
      [&](const KdopAxis<Dim>& axis) { return placed_bounds<Scalar, Dim>(axis, vertices, pose); }, observe);
}

}  // namespace snug::fit
