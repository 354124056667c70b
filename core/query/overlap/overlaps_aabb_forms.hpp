// Tests two axis-aligned boxes in each of their three representations, axis by axis, and tells each axis. The verdicts
// are exact on the numbers as they are stored; aabb_overlap.hpp has the same tests in rounded arithmetic.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2.1.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "geometry/aabb_forms.hpp"
#include "query/overlap/overlaps_slabs.hpp"

namespace snug::query {

/// A line for each axis, and the last for two boxes that overlap; in 2-D there is none for z.
inline constexpr std::array<std::string_view, 4> kMinMaxPseudocode{
    "apart if a.max.x < b.min.x or b.max.x < a.min.x",
    "apart if a.max.y < b.min.y or b.max.y < a.min.y",
    "apart if a.max.z < b.min.z or b.max.z < a.min.z",
    "otherwise they overlap",
};
inline constexpr std::array<std::string_view, 4> kMinWidthsPseudocode{
    "t ← a.min.x - b.min.x, apart if t > b.d.x or -t > a.d.x",
    "t ← a.min.y - b.min.y, apart if t > b.d.y or -t > a.d.y",
    "t ← a.min.z - b.min.z, apart if t > b.d.z or -t > a.d.z",
    "otherwise they overlap",
};
inline constexpr std::array<std::string_view, 4> kCenterRadiusPseudocode{
    "apart if |a.c.x - b.c.x| > a.r.x + b.r.x",
    "apart if |a.c.y - b.c.y| > a.r.y + b.r.y",
    "apart if |a.c.z - b.c.z| > a.r.z + b.r.z",
    "otherwise they overlap",
};

/// The interval that a box covers along a coordinate axis, exactly.
template <class Scalar, int Dim>
[[nodiscard]] Interval interval_of(const Aabb<Scalar, Dim>& box, int i) {
  return {static_cast<double>(box.min[i]), static_cast<double>(box.max[i])};
}
template <class Scalar, int Dim>
[[nodiscard]] Interval interval_of(const AabbMinWidths<Scalar, Dim>& box, int i) {
  const auto min = static_cast<double>(box.min[i]);
  return {min, DoubleDouble::sum(min, static_cast<double>(box.widths[i]))};
}
template <class Scalar, int Dim>
[[nodiscard]] Interval interval_of(const AabbCenterExtents<Scalar, Dim>& box, int i) {
  const auto center = static_cast<double>(box.center[i]), radius = static_cast<double>(box.half_extents[i]);
  return {DoubleDouble::sum(center, -radius), DoubleDouble::sum(center, radius)};
}

/// Hands an axis's step on, at its own line of the pseudocode.
template <class Observer>
struct AtLine {
  Observer& observe;
  int line = 0;
  void operator()(OverlapStep step) {
    step.line = line;
    if constexpr (kWatched<Observer>) observe(std::move(step));
  }
  void count(Operation operation, std::int64_t n) { observe.count(operation, n); }
};

/// Both boxes in the same representation. Exact: each bound is one of the stored numbers or the sum of two, and such a
/// sum loses nothing in twice the digits.
template <template <class, int> class Form, class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_axis_by_axis(const Form<Scalar, Dim>& a, const Form<Scalar, Dim>& b,
                                                           Observer&& observe = {}) {
  OverlapResult<Scalar, Dim> result{.overlap = true};
  const auto axes = kdop_axes<Dim>(2 * Dim);  // those of the coordinates
  for (int i = 0; i < Dim && result.overlap; ++i) {
    AtLine<std::remove_reference_t<Observer>> at_line{observe, i};
    apart_along<Scalar, Dim>(axes[i], interval_of(a, i), interval_of(b, i), result, at_line);
  }
  return result;
}

}  // namespace snug::query
