// What headers of volumes have in common where they split a volume into a core and a radius around it.
#pragma once

#include <vector>

#include "geometry/vector.hpp"

namespace snug {

template <int Dim>
using Corners = std::vector<Vector<double, Dim>>;

/// a - b, rounded once.
template <class Scalar, int Dim>
[[nodiscard]] Vector<double, Dim> difference(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
  return a.template cast<double>() - b.template cast<double>();
}

}  // namespace snug
