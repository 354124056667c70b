// The proof of a convex hull, from the returned numbers and the points alone.
#pragma once

#include "fit/certify.hpp"
#include "geometry/hull.hpp"

namespace snug::fit {

/// What is true of a hull, each in exact arithmetic. Together: it is the convex hull, and its vertices are just the
/// extreme points.
struct HullProof {
  bool of_points = false;  // each vertex is the point that its index says, and of several in one place the first
  bool convex = false;     // closed, bounding a convex polytope or polygon once; or two points apart, or one
  bool extreme = false;    // no vertex lies between others (given that it is convex)
  Index outside = 0;       // how many points it does not hold
  double max_outside = 0;  // the farthest that one lies outside, scene units

  [[nodiscard]] bool holds() const { return of_points && convex && extreme && outside == 0; }
};

/// A surface is convex where each facet sees one point inside from above, each edge bends away from it, and a ray from
/// it meets one facet only. Where rounding leaves no such point between the facets, all are held against all.
/// Source: K. Mehlhorn, S. Näher, M. Seel, R. Seidel, T. Schilz, S. Schirra, C. Uhrig, "Checking geometric programs or
/// verification of geometric structures", 1999.
/// Points are then found by walking over the facets, O(sqrt(facets)) each in practice.
template <class Scalar, int Dim>
[[nodiscard]] HullProof prove_hull(const ConvexHull<Scalar, Dim>& hull, PointSpan<Scalar, Dim> points);

/// The same in the terms of every fitter. on_boundary: the support is the vertices, and each is extreme. optimal: all
/// of the proof holds, so that no convex set that holds the points is smaller.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<ConvexHull<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);

}  // namespace snug::fit
