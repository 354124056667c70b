// Projections onto the axes of k-DOPs: exact except for one rounding outwards.
#pragma once

#include <array>

#include "geometry/kdop.hpp"
#include "number/outward.hpp"

namespace snug {

/// The least Scalar that is not below p . axis. p: finite, and so small that the sum of its coordinates is finite.
template <class Scalar, int Dim>
[[nodiscard]] Scalar project_up(const KdopAxis<Dim>& axis, const Vector<Scalar, Dim>& p) {
  const auto term = [&](int i) { return static_cast<Scalar>(axis[i]) * p[i]; };
  if constexpr (Dim == 2) return sum_up<Scalar>(term(0), term(1));
  else return sum_up<Scalar>(term(0), term(1), term(2));
}

/// The greatest Scalar that is not above p . axis. p: as above.
template <class Scalar, int Dim>
[[nodiscard]] Scalar project_down(const KdopAxis<Dim>& axis, const Vector<Scalar, Dim>& p) {
  return 0 - project_up<Scalar, Dim>(axis, -p);  // not -0
}

/// Makes the slabs from one on as wide as the first Dim, the coordinate slabs, allow: a bound for slabs that are not
/// computed yet. kdop.k: a valid k.
template <class Scalar, int Dim>
void imply_slabs(Kdop<Scalar, Dim>& kdop, std::size_t from) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t slab = from; slab < axes.size(); ++slab) {
    Vector<Scalar, Dim> least, greatest;  // the corners of the box that reach farthest
    for (std::size_t i = 0; i < Dim; ++i) {
      const bool along = axes[slab][i] >= 0;
      least[static_cast<int>(i)] = along ? kdop.min[i] : kdop.max[i];
      greatest[static_cast<int>(i)] = along ? kdop.max[i] : kdop.min[i];
    }
    kdop.min[slab] = project_down<Scalar, Dim>(axes[slab], least);
    kdop.max[slab] = project_up<Scalar, Dim>(axes[slab], greatest);
  }
}

}  // namespace snug
