// The convex hull by Quickhull. Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex
// hulls", 1996.
#pragma once

#include <span>

#include "fit/hull/quickhull_2d.hpp"
#include "fit/hull/quickhull_3d.hpp"

namespace snug::fit {

template <int Dim>
inline constexpr std::span<const std::string_view> kQuickhullPseudocode = kQuickhull3Pseudocode;
template <>
inline constexpr std::span<const std::string_view> kQuickhullPseudocode<2> = kQuickhull2Pseudocode;

/// The convex hull. Its vertices are exactly the extreme points (of coincident points, the first), decided in exact
/// arithmetic whatever the coordinates. support: the vertices, as the hull's indices.
/// points: n >= 1 finite points, scene units. O(n log n) time expected, O(n) memory: in 3-D 36 bytes a point and 200 a
/// vertex, in 2-D 4 bytes a point.
template <class Scalar, int Dim, StepObserver<HullStep<Scalar, Dim>> Observer = Ignore>
Fit<ConvexHull<Scalar, Dim>> quickhull(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  if constexpr (Dim == 2) return quickhull_2d<Scalar>(points, observe);
  else return quickhull_3d<Scalar>(points, observe);
}

}  // namespace snug::fit
