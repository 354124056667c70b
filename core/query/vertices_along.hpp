// Which point of a volume is farthest along a plane's normal, and which against it: for those who watch.
#pragma once

#include "query/classify_steps.hpp"
#include "query/plane_reach.hpp"

namespace snug::query {

/// The part of a step that says where the p- and n-vertex are: normal, signs, vertices and points. For a sphere and any
/// other volume that is no box, the points farthest along the normal and against it.
template <class Scalar, int Dim, class Shape>
[[nodiscard]] PlaneTested<Scalar, Dim> vertices_along(const Plane<Scalar, Dim>& plane, const Shape& volume);

/// A corner of a box, within rounding. bits: 1 for +x, 2 for +y, 4 for +z.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> corner_of(const Aabb<Scalar, Dim>& box, int bits) {
  Vector<Scalar, Dim> corner = box.min;
  for (int i = 0; i < Dim; ++i)
    if ((bits >> i & 1) != 0) corner[i] = box.max[i];
  return corner;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> corner_of(const AabbCenterExtents<Scalar, Dim>& box, int bits) {
  Vector<Scalar, Dim> corner = box.center;
  for (int i = 0; i < Dim; ++i) corner[i] += (bits >> i & 1) != 0 ? box.half_extents[i] : -box.half_extents[i];
  return corner;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> corner_of(const Obb<Scalar, Dim>& box, int bits) {
  Vector<Scalar, Dim> corner = box.center;
  for (int i = 0; i < Dim; ++i)
    corner += box.axes.col(i) * ((bits >> i & 1) != 0 ? box.half_extents[i] : -box.half_extents[i]);
  return corner;
}

/// A plane's normal as a box's own frame has it.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> normal_in_frame(const Plane<Scalar, Dim>& plane, const Obb<Scalar, Dim>& box) {
  Vector<Scalar, Dim> normal;
  for (int i = 0; i < Dim; ++i) normal[i] = along_axis<Scalar>(plane, box, i);
  return normal;
}
template <class Scalar, int Dim, class Shape>
[[nodiscard]] Vector<Scalar, Dim> normal_in_frame(const Plane<Scalar, Dim>& plane, const Shape&) {
  return plane.normal;
}

}  // namespace snug::query
