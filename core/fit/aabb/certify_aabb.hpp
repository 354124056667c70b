// The proof of an axis-aligned box.
#pragma once

#include "fit/certify_volume.hpp"

namespace snug::fit {

/// A support point lies on the boundary where one of its coordinates is a bound of the box.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Aabb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal) {
  const auto held_bounds = [&](const Vector<Scalar, Dim>& p) {
    unsigned held = 0;
    for (int i = 0; i < Dim; ++i) {
      if (p[i] == fit.volume.min[i]) held |= 1u << 2 * i;
      if (p[i] == fit.volume.max[i]) held |= 2u << 2 * i;
    }
    return held;
  };
  return certify_bounds(fit, points, 2 * Dim, claims_optimal, held_bounds);
}

}  // namespace snug::fit
