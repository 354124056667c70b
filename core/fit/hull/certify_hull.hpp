// Proves a convex hull from the returned numbers and the points alone.
#pragma once

#include <span>

#include "fit/certify.hpp"
#include "geometry/hull.hpp"

namespace snug::fit {

/// What has been proven about a hull, in exact arithmetic. If all of it holds, it is the convex hull, and its vertices
/// are exactly the extreme points.
struct HullProof {
  bool of_points = false;  // each vertex is the point that its index names; of coincident points, the first
  bool convex = false;     // closed, around a convex polytope or polygon once; or a segment, or a point
  bool extreme = false;    // no vertex lies between others (given that it is convex)
  Index outside = 0;       // how many points it does not contain
  double max_outside = 0;  // the farthest that one lies outside, scene units

  [[nodiscard]] bool holds() const { return of_points && convex && extreme && outside == 0; }
};

/// A surface is convex if one point lies below every facet, every edge bends away from it, and a ray from it meets one
/// facet only. If rounding leaves no such point, all vertices are tested against all facets.
/// Source: K. Mehlhorn, S. Näher, M. Seel, R. Seidel, T. Schilz, S. Schirra, C. Uhrig, "Checking geometric programs or
/// verification of geometric structures", 1999.
/// Points are then found by walking over the facets, O(sqrt(facets)) each in practice.
template <class Scalar, int Dim>
[[nodiscard]] HullProof prove_hull(const ConvexHull<Scalar, Dim>& hull, PointSpan<Scalar, Dim> points);

/// The same as a certificate. on_boundary: the support set is the set of vertices, and each is extreme. optimal: the
/// whole proof holds, so that no smaller convex set contains the points.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<ConvexHull<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);

/// The farthest that a point lies outside the hull, as the proof says it. at_most: a bound for each point; only those
/// with the largest bounds are looked at, since a point outside takes time that is linear in the hull.
template <class Scalar, int Dim>
[[nodiscard]] double max_outside(const ConvexHull<Scalar, Dim>& hull, PointSpan<Scalar, Dim> points,
                                 std::span<const double> at_most);

}  // namespace snug::fit
