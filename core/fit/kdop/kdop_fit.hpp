// The k-DOP of points: the least and greatest projection onto each of its axes.
// Source: J. T. Klosowski, M. Held, J. S. B. Mitchell, H. Sowizral, K. Zikan, "Efficient collision detection using
// bounding volume hierarchies of k-DOPs", 1998.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/kdop/kdop_steps.hpp"
#include "geometry/kdop_project.hpp"
#include "geometry/point_set.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 4> kKdopPseudocode{
    "for each of the k / 2 axes",
    "  slab ← least to greatest p · axis",
    "  round its bounds outwards",
    "return k-DOP",
};

/// The tightest slab along an axis: the exact projections, rounded outwards. size: at least every |coordinate|; along a
/// coordinate axis, where no sum is rounded, 0 will do.
template <class Scalar, int Dim>
[[nodiscard]] SlabFound slab_of(const KdopAxis<Dim>& axis, PointSpan<Scalar, Dim> points, Scalar size, Scalar& min,
                                Scalar& max) {
  const Scalar error_bound = tolerance::kKdopProjection<Scalar> * size;
  SlabFound found{.least = 0, .greatest = 0};
  min = project_down<Scalar, Dim>(axis, points[0]);
  max = project_up<Scalar, Dim>(axis, points[0]);
  for (Index i = 1; i < points.size(); ++i) {
    const Scalar plain = project<Scalar, Dim>(axis, points[i]);
    if (plain < min + error_bound) {
      const Scalar bound = project_down<Scalar, Dim>(axis, points[i]);
      if (bound < min) {
        min = bound;
        found.least = i;
      }
    }
    if (plain > max - error_bound) {
      const Scalar bound = project_up<Scalar, Dim>(axis, points[i]);
      if (bound > max) {
        max = bound;
        found.greatest = i;
      }
    }
  }
  found.min = static_cast<double>(min);
  found.max = static_cast<double>(max);
  return found;
}

/// The smallest k-DOP, with each bound rounded outwards once.
/// points: n >= 1 finite points, scene units. k: one that Dim has (kdop_axes). O(k n) time: a pass for each slab.
template <class Scalar, int Dim, StepObserver<KdopStep<Scalar, Dim>> Observer = Ignore>
Fit<Kdop<Scalar, Dim>> kdop_fit(PointSpan<Scalar, Dim> points, int k, Observer&& observe = {}) {
  using Step = KdopStep<Scalar, Dim>;
  const auto axes = kdop_axes<Dim>(k);
  Fit<Kdop<Scalar, Dim>> fit{{.k = k}, {}};
  Scalar size = 0;
  for (std::size_t slab = 0; slab < axes.size(); ++slab) {
    Scalar& min = fit.volume.min[slab];
    Scalar& max = fit.volume.max[slab];
    SlabFound found = slab_of<Scalar, Dim>(axes[slab], points, size, min, max);
    found.slab = static_cast<int>(slab);
    observe.count(Operation::kPointsTouched, points.size());
    observe.count(Operation::kDotProducts, points.size());
    observe.count(Operation::kComparisons, 2 * (std::int64_t{points.size()} - 1));
    if (slab < Dim) size = std::max({size, std::abs(min), std::abs(max)});  // the coordinate axes come first
    for (const Index i : {found.least, found.greatest})
      if (std::find(fit.support.begin(), fit.support.end(), i) == fit.support.end()) fit.support.push_back(i);
    if constexpr (kWatched<Observer>) {
      const bool has_volume = slab + 1 >= Dim;
      if (has_volume) imply_slabs(fit.volume, slab + 1);
      observe(Step{2, has_volume, fit.volume, found});
    }
  }
  observe(Step{3, true, fit.volume, Finished{fit.support}});
  return fit;
}

}  // namespace snug::fit
