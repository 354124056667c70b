// Two volumes of a kind into one of that kind which holds both.
//
// What is promised: every point of either volume lies in the result, in exact arithmetic on the numbers as they are.
// Unions of slabs keep that without rounding. Balls and what is swept by them are widened until an exact test holds;
// where that test would need corners that no number says, by what is proven of rounding, which tolerance.hpp has.
//
// The volumes are as their headers say, with coordinates up to PointSet's kLargest. Either may come first: the result
// is the same, number for number (but a hull's, which may begin with another vertex). A volume that holds the other is
// returned as it is; of boxes, capsules and lozenges that touch from within, or so nearly that rounding hides it, one a
// rounding larger may be.
#pragma once

#include "geometry/aabb.hpp"
#include "geometry/capsule.hpp"
#include "geometry/hull.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

/// The smallest: nothing is rounded.
template <class Scalar, int Dim>
[[nodiscard]] Aabb<Scalar, Dim> merge(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
}

/// The smallest of both balls, but for the rounding of its centre.
/// Source: D. Eberly, "3D Game Engine Design", 2000, for the formula.
template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> merge(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b);

/// The smallest box along the axes of either or along the principal axes of all corners, whichever is least, but for
/// kMergedBox. It holds both whether all are read as the meeting of their slabs or as what their edges span.
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> merge(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b);

/// Along one of a few lines (that of either, from the middle of one to that of the other, and between the ends that are
/// farthest apart) the thinnest capsule that holds the four balls at the ends, and then the shortest; of these the
/// least.
template <class Scalar, int Dim>
[[nodiscard]] Capsule<Scalar, Dim> merge(const Capsule<Scalar, Dim>& a, const Capsule<Scalar, Dim>& b);

/// Along the edges of either, or from the middle of one to that of the other, a lozenge that holds the eight balls at
/// the corners: in space as thin as they are; in the plane with the larger of the radii. Of these the least.
template <class Scalar, int Dim>
[[nodiscard]] Lozenge<Scalar, Dim> merge(const Lozenge<Scalar, Dim>& a, const Lozenge<Scalar, Dim>& b);

/// The smallest of its k: nothing is rounded. Of different k the slabs that both have: of a 14- and an 18-DOP six
/// remain.
template <class Scalar, int Dim>
[[nodiscard]] Kdop<Scalar, Dim> merge(const Kdop<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b);

/// The hull of both hulls' vertices, exactly. Where that is one of the two, it is returned as it is. Else indices are
/// places in a's vertices followed by b's. An empty hull adds nothing.
template <class Scalar, int Dim>
[[nodiscard]] ConvexHull<Scalar, Dim> merge(const ConvexHull<Scalar, Dim>& a, const ConvexHull<Scalar, Dim>& b);

}  // namespace snug::fit
