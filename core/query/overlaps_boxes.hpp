// Oriented boxes against each other and against axis-aligned ones.
#pragma once

#include "geometry/aabb_forms.hpp"
#include "query/gjk.hpp"
#include "query/overlap_result.hpp"

namespace snug::query {

/// An axis-aligned box as an oriented one: no smaller, and larger by no more than rounding.
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> obb_of(const Aabb<Scalar, Dim>& box) {
  const AabbCenterExtents<Scalar, Dim> form = center_extents_of(box);
  return {form.center, Matrix<Scalar, Dim>::Identity(), form.half_extents};
}

template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> test_boxes(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  const auto separation = *gjk(a, b);
  OverlapResult<Scalar, Dim> result{.overlap = separation.overlap, .tests = separation.supports};
  if (!result.overlap) result.separating_axis = {"closest_points", separation.direction, separation.gap};
  return result;
}

template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> test_boxes(const Aabb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  return test_boxes(obb_of(a), b);
}

}  // namespace snug::query
