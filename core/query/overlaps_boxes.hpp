// Tests oriented boxes against each other and against axis-aligned ones, by separating axes.
#pragma once

#include "geometry/aabb_forms.hpp"
#include "query/obb_sat.hpp"
#include "query/overlap_result.hpp"

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
template <class Scalar, int Dim>
[[nodiscard]] bool boxes_overlap(const Aabb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  return obbs_overlap(obb_of(a), b);
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
