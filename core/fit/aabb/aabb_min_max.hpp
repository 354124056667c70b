// The axis-aligned box: the least and greatest coordinate along each axis.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, section 4.2.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/aabb/aabb_steps.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 5> kAabbMinMaxPseudocode{
    "box ← the first point",
    "for each point p",
    "  if p outside: widen the box to p",
    "name the points on each face",

    "return box",
};

/// Widens the box to the point; extremes: the points on its faces. Returns whether the point was outside.
template <class Scalar, int Dim>
bool widen_to_hold(Aabb<Scalar, Dim>& box, ExtremesFound<Scalar, Dim>& extremes, const Vector<Scalar, Dim>& point,
                   Index index) {
  bool outside = false;
  for (int axis = 0; axis < Dim; ++axis) {
    if (point[axis] < box.min[axis]) {
      box.min[axis] = point[axis];
      extremes.least[axis] = index;
      outside = true;
    }
    if (point[axis] > box.max[axis]) {
      box.max[axis] = point[axis];
      extremes.greatest[axis] = index;
      outside = true;
    }
  }
  return outside;
}

/// The points that the faces touch, each once.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<Index> support_of(const ExtremesFound<Scalar, Dim>& extremes) {
  std::vector<Index> support;
  for (const auto* ends : {&extremes.least, &extremes.greatest})
    for (const Index i : *ends)
      if (std::find(support.begin(), support.end(), i) == support.end()) support.push_back(i);
  return support;
}

/// The smallest axis-aligned box, without any rounding.
/// points: n >= 1 finite points, scene units. O(n) time: one pass, 2 Dim comparisons a point.
template <class Scalar, int Dim, StepObserver<AabbStep<Scalar, Dim>> Observer = Ignore>
Fit<Aabb<Scalar, Dim>> aabb_min_max(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = AabbStep<Scalar, Dim>;
  Aabb<Scalar, Dim> box{points[0], points[0]};
  ExtremesFound<Scalar, Dim> extremes;
  observe(Step{0, true, box, BoxWidened{0}});
  for (Index i = 1; i < points.size(); ++i)
    if (widen_to_hold(box, extremes, points[i], i)) observe(Step{2, true, box, BoxWidened{i}});
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kComparisons, 2 * Dim * (std::int64_t{points.size()} - 1));
  observe(Step{3, true, box, extremes});
  std::vector<Index> support = support_of(extremes);
  observe(Step{4, true, box, Finished{support}});
  return {box, std::move(support)};
}

}  // namespace snug::fit
