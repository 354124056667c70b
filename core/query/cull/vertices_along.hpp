// Which point of a volume is farthest along a plane's normal, and which against it, for observers.
#pragma once

#include "query/cull/classify_steps.hpp"
#include "query/cull/plane_reach.hpp"

namespace snug::query {

/// Fills in the part of a step about the p- and n-vertex: normal, signs, vertices and points. For any volume that is
/// not a box, fills in the points farthest along the normal and against it.
template <class Scalar, int Dim, class Shape>
[[nodiscard]] PlaneTested<Scalar, Dim> vertices_along(const Plane<Scalar, Dim>& plane, const Shape& volume);

/// A vertex of a box, within rounding. bits: 1 for +x, 2 for +y, 4 for +z.
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

/// A plane's normal in the box's frame.
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
