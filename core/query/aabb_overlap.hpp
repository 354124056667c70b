// Whether two axis-aligned boxes overlap, in each of their three representations. Touching boxes overlap.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2.1.
//
// None says "apart" of boxes that meet: rounding never changes the order of two numbers, so that a difference which is
// at most a width is so when both are rounded. The other way it may: a gap is not seen where it is lost in rounding, by
// as much as each test says.
#pragma once

#include <cmath>

#include "geometry/aabb_forms.hpp"

namespace snug::query {

/// Exact: comparisons alone. Four of them in 2-D, six in 3-D, at worst.
template <class Scalar, int Dim>
[[nodiscard]] bool aabbs_overlap(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  for (int i = 0; i < Dim; ++i)
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
  return true;
}

/// A gap up to u times the distance of the two minima may be lost, or any where that distance overflows.
template <class Scalar, int Dim>
[[nodiscard]] bool aabbs_overlap(const AabbMinWidths<Scalar, Dim>& a, const AabbMinWidths<Scalar, Dim>& b) {
  for (int i = 0; i < Dim; ++i) {
    const Scalar distance = a.min[i] - b.min[i];
    if (distance > b.widths[i] || -distance > a.widths[i]) return false;
  }
  return true;
}

/// A gap up to 2u times the distance of the two centres may be lost: one rounding for it, one for the sum of the
/// extents; or any where both overflow. One comparison an axis.
template <class Scalar, int Dim>
[[nodiscard]] bool aabbs_overlap(const AabbCenterExtents<Scalar, Dim>& a, const AabbCenterExtents<Scalar, Dim>& b) {
  for (int i = 0; i < Dim; ++i)
    if (std::abs(a.center[i] - b.center[i]) > a.half_extents[i] + b.half_extents[i]) return false;
  return true;
}

}  // namespace snug::query
