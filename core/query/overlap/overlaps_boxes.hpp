// Tests oriented boxes against each other and against axis-aligned ones, by separating axes.
#pragma once

#include "geometry/aabb_forms.hpp"
#include "query/overlap/obb_sat.hpp"
#include "query/overlap/overlap_result.hpp"

namespace snug::query {

/// An axis-aligned box as an oriented one: no smaller, and larger by no more than rounding.
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> obb_of(const Aabb<Scalar, Dim>& box) {
  const AabbCenterExtents<Scalar, Dim> form = center_extents_of(box);
  return {form.center, Matrix<Scalar, Dim>::Identity(), form.half_extents};
}

/// The verdict of test_boxes.
template <class Scalar, int Dim>
[[nodiscard]] bool boxes_overlap(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  return obbs_overlap(a, b);
}
/// The axis-aligned box's centre and extents, rounded as they come, are off by 2u of its bounds, and those of obb_of by
/// as much the other way; a direction has up to three coordinates, and the sums here round once more.
template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] std::optional<bool> apart_filter(const Aabb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  const Obb<Scalar, Dim> box{a.min / 2 + a.max / 2, Matrix<Scalar, Dim>::Identity(), a.max / 2 - a.min / 2};
  const Scalar bounds = a.min.template lpNorm<1>() + a.max.template lpNorm<1>();
  return apart_filter(box, b, 16 * tolerance::kRoundoff<Scalar> * bounds);
}

template <class Scalar, int Dim>
[[nodiscard]] bool boxes_overlap(const Aabb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  if (const auto apart = apart_filter(a, b)) [[likely]]
    return !*apart;
  return obb_sat(obb_of(a), b).overlap;
}

/// An exact test; the axis is the first that separates.
template <class Scalar, int Dim, StepObserver<SatStep<Scalar, Dim>> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_boxes(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b,
                                                    Observer&& observe = {}) {
  const SatResult<Scalar, Dim> sat = obb_sat(a, b, SatExtent::kFirst, observe);
  OverlapResult<Scalar, Dim> result{.overlap = sat.overlap, .tests = sat.tests};
  if (!sat.overlap)
    result.separating_axis = {kAxisKindNames[static_cast<std::size_t>(sat.axis.kind)], sat.axis.direction,
                              sat.axis.gap};
  return result;
}

/// A test that is exact except for the rounding of the axis-aligned box's centre and extents.
template <class Scalar, int Dim, StepObserver<SatStep<Scalar, Dim>> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_boxes(const Aabb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b,
                                                    Observer&& observe = {}) {
  return test_boxes(obb_of(a), b, observe);
}

}  // namespace snug::query
