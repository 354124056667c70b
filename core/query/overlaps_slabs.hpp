// Tests boxes and k-DOPs by their intervals along the axes that they share.
// Source: J. Klosowski, M. Held, J. Mitchell, H. Sowizral, K. Zikan, "Efficient collision detection using bounding
// volume hierarchies of k-DOPs", 1998.
#pragma once

#include <span>

#include "geometry/aabb.hpp"
#include "geometry/kdop.hpp"
#include "number/double_double.hpp"
#include "query/overlap_result.hpp"
#include "query/overlap_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// The extent of a volume along one of the k-DOP axes (whose entries are -1, 0 and 1), with twice the digits: exact for
/// an AABB, and for a slab of the k-DOP itself.
struct Interval {
  DoubleDouble min, max;
};

/// The projection on the axis times its length: callers who want scene units divide by it.
template <class Scalar, int Dim>
[[nodiscard]] Interval interval_along(const Aabb<Scalar, Dim>& box, const KdopAxis<Dim>& axis) {
  Interval interval;
  for (std::size_t i = 0; i < Dim; ++i) {
    if (axis[i] == 0) continue;
    const auto least = static_cast<double>(box.min[static_cast<int>(i)]);
    const auto greatest = static_cast<double>(box.max[static_cast<int>(i)]);
    interval.min += axis[i] > 0 ? least : -greatest;
    interval.max += axis[i] > 0 ? greatest : -least;
  }
  return interval;
}

template <class Scalar, int Dim>
[[nodiscard]] Interval interval_along(const Kdop<Scalar, Dim>& kdop, std::size_t slab) {
  return {static_cast<double>(kdop.min[slab]), static_cast<double>(kdop.max[slab])};
}

template <int Dim>
[[nodiscard]] SlabTested slab_tested(const KdopAxis<Dim>& axis, const Interval& a, const Interval& b) {
  SlabTested fact{.separates = a.max < b.min || b.max < a.min};
  for (std::size_t i = 0; i < Dim; ++i) fact.direction[static_cast<int>(i)] = axis[i];
  const double length = fact.direction.norm();
  fact.direction /= length;
  fact.least_a = a.min.value() / length, fact.greatest_a = a.max.value() / length;
  fact.least_b = b.min.value() / length, fact.greatest_b = b.max.value() / length;
  return fact;
}

/// Whether the intervals along one axis are apart; if so, that is the separating axis.
template <class Scalar, int Dim, class Observer>
bool apart_along(const KdopAxis<Dim>& axis, const Interval& a, const Interval& b, OverlapResult<Scalar, Dim>& result,
                 Observer& observe) {
  ++result.tests;
  const bool before = a.max < b.min;
  observe.count(Operation::kComparisons, before ? 1 : 2);
  if constexpr (kWatched<Observer>) observe(OverlapStep{2, slab_tested<Dim>(axis, a, b)});
  if (!before && !(b.max < a.min)) return false;
  Vector<double, Dim> direction;
  for (std::size_t i = 0; i < Dim; ++i) direction[static_cast<int>(i)] = before ? axis[i] : -axis[i];
  const double length = direction.norm();
  const double gap = (before ? b.min - a.max : a.min - b.max).value() / length;
  result.overlap = false;
  result.separating_axis = {"slab", (direction / length).template cast<Scalar>(),
                            std::max(static_cast<Scalar>(gap), std::numeric_limits<Scalar>::denorm_min())};
  return true;
}

/// Exact.
template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_slabs(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b,
                                                    Observer&& observe = {}) {
  OverlapResult<Scalar, Dim> result{.overlap = true};
  for (const auto& axis : kdop_axes<Dim>(2 * Dim))
    if (apart_along<Scalar, Dim>(axis, interval_along<Scalar, Dim>(a, axis), interval_along<Scalar, Dim>(b, axis),
                                 result, observe))
      break;
  return result;
}

/// Tests all slabs of the k-DOP. If k is larger than a box's, this is only a first test: the volumes may be apart along
/// none of these axes, where an edge of one passes an edge of the other.
template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_slabs(const Aabb<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b,
                                                    Observer&& observe = {}) {
  OverlapResult<Scalar, Dim> result{.overlap = true};
  const auto axes = kdop_axes<Dim>(b.k);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (apart_along<Scalar, Dim>(axes[i], interval_along<Scalar, Dim>(a, axes[i]), interval_along(b, i), result,
                                 observe))
      break;
  return result;
}

/// Two k-DOPs of equal k are compared in all slabs, others in those of the coordinate axes, with which every k begins.
template <class Scalar, int Dim, StepObserver<OverlapStep> Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_slabs(const Kdop<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b,
                                                    Observer&& observe = {}) {
  OverlapResult<Scalar, Dim> result{.overlap = true};
  const auto axes = kdop_axes<Dim>(a.k == b.k ? a.k : 2 * Dim);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (apart_along<Scalar, Dim>(axes[i], interval_along(a, i), interval_along(b, i), result, observe)) break;
  return result;
}

}  // namespace snug::query
