// Merges two volumes of a kind into one of that kind that contains both.
//
// The result contains every point of either volume, in exact arithmetic on the numbers as they are. Unions of slabs do
// so without rounding. Balls and sphere-swept volumes are widened until an exact test passes; where that test would
// need vertices that have no exact numbers, they are widened by a proven error bound (tolerance.hpp).
//
// The volumes are as their headers say, with coordinates up to PointSet's kLargest. Their order does not matter: the
// result has the same numbers (though a hull may begin with another vertex). A volume that contains the other is
// returned as it is. But where boxes, capsules or lozenges touch from inside, or almost, the result may be larger by a
// rounding error.
#pragma once

#include "geometry/aabb.hpp"
#include "geometry/capsule.hpp"
#include "geometry/hull.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

/// The smallest AABB: nothing is rounded.
template <class Scalar, int Dim>
[[nodiscard]] Aabb<Scalar, Dim> merge(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
}

/// The smallest ball around both balls, but for the rounding of its centre.
/// Source: D. Eberly, "3D Game Engine Design", 2000, for the formula.
template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> merge(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b);

/// The smallest, but for kMergedBox, of three boxes: along the axes of a, of b, and along the principal axes of all
/// vertices. It contains both, whether boxes are read as intersections of slabs or as spans of edges.
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> merge(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b);

/// For each of a few directions (of either segment, from one midpoint to the other, and between the ends that are
/// farthest apart), the shortest of the thinnest capsules that contain the four balls at the ends. Returns the smallest
/// of these.
template <class Scalar, int Dim>
[[nodiscard]] Capsule<Scalar, Dim> merge(const Capsule<Scalar, Dim>& a, const Capsule<Scalar, Dim>& b);

/// The smallest of a few lozenges (along either's edges, and from one centre to the other) that contain the eight balls
/// at the vertices: in space as thin as they allow, in the plane with the larger of the radii.
template <class Scalar, int Dim>
[[nodiscard]] Lozenge<Scalar, Dim> merge(const Lozenge<Scalar, Dim>& a, const Lozenge<Scalar, Dim>& b);

/// The smallest of its k: nothing is rounded. If their k differ, the result has the slabs that both have: a 14- and an
/// 18-DOP leave a 6-DOP.
template <class Scalar, int Dim>
[[nodiscard]] Kdop<Scalar, Dim> merge(const Kdop<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b);

/// The hull of both hulls' vertices, exactly. If that is one of the two hulls, it is returned as it is. Otherwise the
/// indices refer to a's vertices followed by b's. An empty hull adds nothing.
template <class Scalar, int Dim>
[[nodiscard]] ConvexHull<Scalar, Dim> merge(const ConvexHull<Scalar, Dim>& a, const ConvexHull<Scalar, Dim>& b);

}  // namespace snug::fit
