// A wrong test, kept for those who might invent it: boxes overlap if their axis-aligned bounding boxes do. It never
// calls overlapping boxes apart, but it calls boxes overlapping that are apart.
#pragma once

#include <array>
#include <string_view>

#include "query/exhibits/wrong_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 3> kExtentsOnlyPseudocode{
    "for each coordinate axis",
    "  apart if the AABBs' extents are disjoint",
    "overlap (wrong if AABB corners are empty)",
};

/// The answer of the wrong test. a, b: as for obb_sat.
template <class Scalar, int Dim, StepObserver<WrongStep> Observer = Ignore>
bool extents_only(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, Observer&& observe = {}) {
  const Vector<Scalar, Dim> half_a = a.axes.cwiseAbs() * a.half_extents, half_b = b.axes.cwiseAbs() * b.half_extents;
  for (int axis = 0; axis < Dim; ++axis) {
    const bool apart = std::abs(b.center[axis] - a.center[axis]) > half_a[axis] + half_b[axis];
    observe.count(Operation::kComparisons, 1);
    if constexpr (kWatched<Observer>)
      observe(WrongStep{1, OutlinesCompared{axis, static_cast<double>(a.center[axis] - half_a[axis]),
                                            static_cast<double>(a.center[axis] + half_a[axis]),
                                            static_cast<double>(b.center[axis] - half_b[axis]),
                                            static_cast<double>(b.center[axis] + half_b[axis]), apart}});
    if (!apart) continue;
    observe(WrongStep{1, Claimed{false}});
    return false;
  }
  observe(WrongStep{2, Claimed{true}});
  return true;
}

}  // namespace snug::query
