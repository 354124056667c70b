// The oriented bounding box, in its working form.
#pragma once

#include "geometry/core.hpp"
#include "geometry/pose.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// All p with |(p - center) . axis_i| <= half_extents_i: three slabs (in 2-D two), by which exact tests decide.
template <class Scalar, int Dim>
struct Obb {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  Matrix<Scalar, Dim> axes = Matrix<Scalar, Dim>::Identity();      // columns: unit, perpendicular, right-handed
  Vector<Scalar, Dim> half_extents = Vector<Scalar, Dim>::Zero();  // >= 0, scene units
  SNUG_FIELDS(center, axes, half_extents);
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Obb<Scalar, Dim>& box) {
  return (2 * box.half_extents.template cast<double>()).prod();
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Obb<Scalar, Dim>& box) {
  return box.center;
}

template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Obb<Scalar, Dim>& box, const Vector<Scalar, Dim>& origin) {
  const Vector<double, Dim> center = difference(box.center, origin);
  const Matrix<double, Dim> edges =
      box.axes.template cast<double>() * box.half_extents.template cast<double>().asDiagonal();
  Corners<Dim> corners;
  for (int choice = 0; choice < (1 << Dim); ++choice) {
    Vector<double, Dim> arm = Vector<double, Dim>::Zero();  // summed by itself, so that opposite corners are opposite
    for (int i = 0; i < Dim; ++i) arm += edges.col(i) * ((choice >> i & 1) != 0 ? 1 : -1);
    corners.push_back(center + arm);
  }
  return corners;
}

/// The normal's coordinate along a box's axis.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Number along_axis(const Plane<Scalar, Dim>& plane, const Obb<Scalar, Dim>& box, int axis) {
  return dot_as<Number, Scalar, Dim>(plane.normal, Vector<Scalar, Dim>(box.axes.col(axis)));
}

/// The normal in the box's frame: from the centre to a vertex, each half extent counts with or against it.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Obb<Scalar, Dim>& box) {
  Number radius = magnitude(along_axis<Number>(plane, box, 0)) * exactly<Number>(box.half_extents[0]);
  for (int i = 1; i < Dim; ++i)
    radius += magnitude(along_axis<Number>(plane, box, i)) * exactly<Number>(box.half_extents[i]);
  return around<Number>(plane, box.center, radius);
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Obb<Scalar, Dim>& box) {
  return largest<Scalar, Dim>(box.center) + box.half_extents.sum();
}

template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> moved(const Obb<Scalar, Dim>& box, const Vector<Scalar, Dim>& by) {
  return {box.center + by, box.axes, box.half_extents};
}
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> turned(const Obb<Scalar, Dim>& box, const Matrix<Scalar, Dim>& rotation) {
  return {box.center, orthonormal<Scalar, Dim>(rotation * box.axes), box.half_extents};
}

}  // namespace snug
