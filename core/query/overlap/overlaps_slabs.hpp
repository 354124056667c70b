// Tests boxes and k-DOPs by their intervals along the axes that they share.
// Source: J. Klosowski, M. Held, J. Mitchell, H. Sowizral, K. Zikan, "Efficient collision detection using bounding
// volume hierarchies of k-DOPs", 1998.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "geometry/aabb.hpp"
#include "geometry/kdop.hpp"
#include "geometry/tolerance.hpp"
#include "number/double_double.hpp"
#include "query/overlap/aabb_overlap.hpp"
#include "query/overlap/overlap_result.hpp"
#include "query/overlap/overlap_steps.hpp"
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
  fact.least_a = a.min.value() / length;
  fact.greatest_a = a.max.value() / length;
  fact.least_b = b.min.value() / length;
  fact.greatest_b = b.max.value() / length;
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

/// The verdict of test_slabs.
template <class Scalar, int Dim>
[[nodiscard, gnu::always_inline]] inline bool slabs_overlap(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  return aabbs_overlap(a, b);
}

/// The verdict of test_slabs on two k-DOPs: comparisons alone, of stored numbers, and therefore exact.
template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] bool slabs_overlap(const Kdop<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b) {
  const auto apart = [&](int slab) { return a.max[slab] < b.min[slab] || b.max[slab] < a.min[slab]; };
  for (int i = 0; i < Dim; ++i)  // mostly these are enough, and k is not even read
    if (apart(i)) return false;
  const int slabs = a.k == b.k ? a.k / 2 : Dim;
  for (int i = Dim; i < slabs; ++i)
    if (apart(i)) return false;
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

/// Tests all slabs of the k-DOP. If k is larger than a box's, this is conservative: bodies may be apart along none of
/// these axes, where an edge of one passes an edge of the other.
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

/// The verdict of test_slabs: the box's extents along the k-DOP's axes are rounded sums, and what they leave in doubt
/// is decided by exact ones.
template <class Scalar, int Dim>
[[nodiscard, gnu::flatten]] bool slabs_overlap(const Aabb<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b) {
  const auto axes = kdop_axes<Dim>(b.k);
  const Scalar size = std::max(a.min.cwiseAbs().maxCoeff(), a.max.cwiseAbs().maxCoeff());
  const Scalar error_bound = tolerance::kKdopProjection<Scalar> * size + std::numeric_limits<Scalar>::min();
  bool in_doubt = false;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Scalar least = 0, greatest = 0;
    for (int j = 0; j < Dim; ++j) {
      if (axes[i][j] == 0) continue;
      least += axes[i][j] > 0 ? a.min[j] : -a.max[j];
      greatest += axes[i][j] > 0 ? a.max[j] : -a.min[j];
    }
    const Scalar gap = std::max(b.min[i] - greatest, least - b.max[i]);
    if (gap > error_bound) return false;
    in_doubt = in_doubt || gap > -error_bound;
  }
  return !in_doubt || test_slabs(a, b).overlap;
}

/// Two k-DOPs of equal k are compared in all slabs, others in those of the coordinate axes, with which every k begins.
/// As conservative.
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
