// Turns Quickhull's surface into the hull: coplanar facets become one face, and only extreme points stay.
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", 1996, merge facets as
// the hull grows, within the rounding error; here they are merged once at the end, where they are coplanar exactly.
#pragma once

#include <vector>

#include "fit/hull/quickhull_surface.hpp"
#include "geometry/hull.hpp"

namespace snug::fit {

template <class Scalar>
struct MergedFaces {
  ConvexHull<Scalar, 3> hull;  // vertices by rising index
  Index faces = 0;             // how many faces had more than one facet
  std::vector<Index> dropped;  // points on the surface that lie inside a face or an edge
};

/// Each face is cut into a fan of triangles around one of its vertices. No three vertices of a convex polygon lie on a
/// line, so every triangle has an area.
template <class Scalar>
[[nodiscard]] MergedFaces<Scalar> merge_faces(const HullSurface<Scalar>& surface, PointSpan<Scalar, 3> points);

}  // namespace snug::fit
