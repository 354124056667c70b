// The oriented bounding box, in its working form.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

/// All p with |(p - center) . axis_i| <= half_extents_i: three slabs (in 2-D two), which is how it is judged exactly.
template <class Scalar, int Dim>
struct Obb {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  Matrix<Scalar, Dim> axes = Matrix<Scalar, Dim>::Identity();      // one a column: unit, perpendicular, right-handed
  Vector<Scalar, Dim> half_extents = Vector<Scalar, Dim>::Zero();  // >= 0, scene units
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Obb<Scalar, Dim>& box) {
  return (2 * box.half_extents.template cast<double>()).prod();
}

}  // namespace snug
