// Where a volume is of a frustum, in arithmetic that does not round, by means that share no line with the code under
// test: in double where that is certain by far, in about 106 bits where that is, else in rationals.
#pragma once

#include "geometry/aabb_forms.hpp"
#include "geometry/capsule.hpp"
#include "geometry/frustum.hpp"
#include "geometry/hull.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"
#include "query/cull/classify_steps.hpp"

namespace snug::exact {

/// A volume in double and in space, as a sum of what each coordinate may be: center + sum of segments, of radius.
/// Points of the plane have z = 0.
struct SumOfSegments {
  struct Segment {
    double direction[3];
    double least, most;  // times the direction
  };
  double center[3]{};
  Segment segments[3]{};
  int count = 0;
  double radius = 0;
};
template <class Scalar, int Dim>
SumOfSegments sum_of(const Vector<Scalar, Dim>& point);
template <class Scalar, int Dim>
SumOfSegments sum_of(const Sphere<Scalar, Dim>& sphere);
template <class Scalar, int Dim>
SumOfSegments sum_of(const Aabb<Scalar, Dim>& box);
template <class Scalar, int Dim>
SumOfSegments sum_of(const AabbCenterExtents<Scalar, Dim>& box);
template <class Scalar, int Dim>
SumOfSegments sum_of(const Obb<Scalar, Dim>& box);
template <class Scalar, int Dim>
SumOfSegments sum_of(const Lozenge<Scalar, Dim>& lozenge);

/// By the planes, each for itself. in_rationals: without the quicker ways.
template <class Scalar, int Dim>
query::Culling classify(const Frustum<Scalar, Dim>& frustum, const SumOfSegments& volume, bool in_rationals = false);

/// The same of a capsule, as spheres at both ends.
template <class Scalar, int Dim>
query::Culling classify(const Frustum<Scalar, Dim>& frustum, const Capsule<Scalar, Dim>& capsule);
/// The convex hull of any points.
template <class Scalar, int Dim>
query::Culling classify(const Frustum<Scalar, Dim>& frustum, const std::vector<Vector<Scalar, Dim>>& points);
/// By all points in rationals where Dim slab planes meet within all slabs.
template <class Scalar, int Dim>
query::Culling classify(const Frustum<Scalar, Dim>& frustum, const Kdop<Scalar, Dim>& kdop);

/// Whether a box and a frustum, given by its planes, share a point: by elimination of coordinates (Fourier, Motzkin) in
/// rationals.
template <class Scalar, int Dim>
bool overlap(const Frustum<Scalar, Dim>& frustum, const Obb<Scalar, Dim>& box);

}  // namespace snug::exact
