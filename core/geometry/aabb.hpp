// The axis-aligned bounding box, in its working form.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

/// All p with min <= p <= max in every coordinate, scene units.
template <class Scalar, int Dim>
struct Aabb {
  Vector<Scalar, Dim> min = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> max = Vector<Scalar, Dim>::Zero();  // >= min
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Aabb<Scalar, Dim>& box) {
  return (box.max.template cast<double>() - box.min.template cast<double>()).prod();
}

}  // namespace snug
