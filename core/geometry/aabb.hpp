// The axis-aligned bounding box, in its working form.
#pragma once

#include "geometry/core.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// All p with min <= p <= max in every coordinate, scene units.
template <class Scalar, int Dim>
struct Aabb {
  Vector<Scalar, Dim> min = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> max = Vector<Scalar, Dim>::Zero();  // >= min
  SNUG_FIELDS(min, max);
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Aabb<Scalar, Dim>& box) {
  return (box.max.template cast<double>() - box.min.template cast<double>()).prod();
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Aabb<Scalar, Dim>& box) {
  return box.min;
}

template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Aabb<Scalar, Dim>& box, const Vector<Scalar, Dim>& origin) {
  const Vector<double, Dim> least = difference(box.min, origin);
  const Vector<double, Dim> greatest = difference(box.max, origin);
  Corners<Dim> corners;
  for (int choice = 0; choice < (1 << Dim); ++choice) {
    Vector<double, Dim>& corner = corners.emplace_back(least);
    for (int i = 0; i < Dim; ++i)
      if ((choice >> i & 1) != 0) corner[i] = greatest[i];
  }
  return corners;
}

/// The sign of each coordinate of the normal chooses min or max: that gives the n-vertex, and the opposite choice the
/// p-vertex.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Aabb<Scalar, Dim>& box) {
  Vector<Scalar, Dim> n_vertex, p_vertex;
  for (int i = 0; i < Dim; ++i) {
    const bool towards_max = plane.normal[i] >= 0;
    n_vertex[i] = towards_max ? box.min[i] : box.max[i];
    p_vertex[i] = towards_max ? box.max[i] : box.min[i];
  }
  return {value_at<Number>(plane, n_vertex), value_at<Number>(plane, p_vertex)};
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Aabb<Scalar, Dim>& box) {
  return std::max(largest<Scalar, Dim>(box.min), largest<Scalar, Dim>(box.max));
}

template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Aabb<Scalar, Dim>& box, const std::type_identity_t<Vector<Scalar, Dim>>& point) {
  return (point.array() >= box.min.array()).all() && (point.array() <= box.max.array()).all();
}

template <class Scalar, int Dim>
[[nodiscard]] Aabb<Scalar, Dim> moved(const Aabb<Scalar, Dim>& box, const Vector<Scalar, Dim>& by) {
  return {box.min + by, box.max + by};
}

}  // namespace snug
