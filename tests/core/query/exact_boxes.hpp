// Whether two boxes overlap, decided in integers and rationals by means that share no line with the code under test.
#pragma once

#include "geometry/obb.hpp"

namespace snug::exact {

/// By the corners' projections onto the normal of every pair of edge directions. Complete for boxes that are not flat.
template <int Dim>
bool overlap_by_corners(const Obb<double, Dim>& a, const Obb<double, Dim>& b);

/// By linear programming, complete whatever is flat: is there a point that is both center + sum s_i h_i u_i?
template <int Dim>
bool overlap_by_simplex(const Obb<double, Dim>& a, const Obb<double, Dim>& b);

template <int Dim>
Obb<double, Dim> in_double(const Obb<float, Dim>& box) {
  return {box.center.template cast<double>(), box.axes.template cast<double>(),
          box.half_extents.template cast<double>()};
}
template <int Dim>
bool overlap_by_corners(const Obb<float, Dim>& a, const Obb<float, Dim>& b) {
  return overlap_by_corners(in_double(a), in_double(b));
}
template <int Dim>
bool overlap_by_simplex(const Obb<float, Dim>& a, const Obb<float, Dim>& b) {
  return overlap_by_simplex(in_double(a), in_double(b));
}

}  // namespace snug::exact
