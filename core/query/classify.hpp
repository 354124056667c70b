// Is a volume inside a frustum, outside, or does it cross its border? Plane by plane.
// Source: U. Assarsson, T. Möller, "Optimized view frustum culling algorithms for bounding boxes", 2000: p- and n-vertex,
// plane masking, temporal coherence. N. Greene, "Detecting intersection of a rectangular solid and a convex polyhedron",
// 1994, for p- and n-vertex.
//
// All answers are those of exact arithmetic on the numbers as they are, in float as in double: a volume is outside just
// where all of it is on the outer side of one plane, and inside where none of it is on the outer side of any. So nothing
// that touches the frustum is ever called outside, and nothing that sticks out inside. But what is outside without being
// so of one plane (near the frustum's edges and corners) is called intersecting: how often, query/frustum_sat.hpp tells.
#pragma once

#include <type_traits>

#include "geometry/aabb_forms.hpp"
#include "geometry/volume.hpp"
#include "query/classify_steps.hpp"
#include "query/plane_reach.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// Whether the test ends at the first plane that the volume is outside of, or goes on to all.
enum class CullExtent : std::uint8_t { kFirst, kAll };

/// What is known before.
struct CullPlan {
  PlaneSet planes = ~PlaneSet{0};        // to be tested: the crossing planes of a volume that holds this one (masking)
  int first = -1;                        // tested first: what rejected this volume last time (temporal coherence)
  CullExtent extent = CullExtent::kFirst;
};

/// volume: a point (Vector), a Sphere, an Aabb, an AabbCenterExtents, an Obb, a Capsule, a Lozenge, a Kdop or a ConvexHull;
/// not empty; coordinates finite, no larger than PointSet takes. As exact arithmetic has them, an OBB is all
/// center + sum s_i h_i u_i with |s_i| <= 1 and a lozenge what is near its parallelogram, whether or not their axes and
/// edges are quite perpendicular. Observers count an orientation test for each vertex that is held against a plane.
template <class Scalar, int Dim, class Shape, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult classify(const Frustum<Scalar, Dim>& frustum, const Shape& volume, const CullPlan& plan = {}, Observer&& observe = {});

/// The same of a volume of which only the running program knows what it is.
template <class Scalar, int Dim, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult classify_volume(const Frustum<Scalar, Dim>& frustum, const Volume<Scalar, Dim>& volume, const CullPlan& plan = {},
                           Observer&& observe = {}) {
  return std::visit([&](const auto& shape) { return classify(frustum, shape, plan, observe); }, volume);
}

}  // namespace snug::query
