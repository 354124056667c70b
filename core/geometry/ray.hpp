// The ray.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

/// All origin + t direction, t >= 0.
template <class Scalar, int Dim>
struct Ray {
  Vector<Scalar, Dim> origin = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> direction = Vector<Scalar, Dim>::Zero();  // any length but 0
};

}  // namespace snug
