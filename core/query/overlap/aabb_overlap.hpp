// Whether two axis-aligned boxes overlap, in each of their three representations. Touching boxes overlap.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2.1.
//
// No test calls boxes apart that touch or overlap. Rounding never changes the order of two numbers, so a difference
// that is at most a width stays so when both are rounded. But a test may miss a gap that is lost in rounding; each says
// how large that gap can be.
#pragma once

#include <cmath>

#include "geometry/aabb_forms.hpp"

namespace snug::query {

/// Exact: comparisons alone. Four of them in 2-D, six in 3-D, at worst.
template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] bool aabbs_overlap(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  for (int i = 0; i < Dim; ++i)
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
  return true;
}

/// May miss a gap of up to u times the distance between the two minima, or any gap if that distance overflows.
template <class Scalar, int Dim>
[[nodiscard]] bool aabbs_overlap(const AabbMinWidths<Scalar, Dim>& a, const AabbMinWidths<Scalar, Dim>& b) {
  for (int i = 0; i < Dim; ++i) {
    const Scalar distance = a.min[i] - b.min[i];
    if (distance > b.widths[i] || -distance > a.widths[i]) return false;
  }
  return true;
}

/// May miss a gap of up to 2u times the distance between the two centres (one rounding for it, one for the sum of the
/// extents), or any gap if both overflow. One comparison for each axis.
template <class Scalar, int Dim>
[[nodiscard]] bool aabbs_overlap(const AabbCenterExtents<Scalar, Dim>& a, const AabbCenterExtents<Scalar, Dim>& b) {
  for (int i = 0; i < Dim; ++i)
    if (std::abs(a.center[i] - b.center[i]) > a.half_extents[i] + b.half_extents[i]) return false;
  return true;
}

}  // namespace snug::query
