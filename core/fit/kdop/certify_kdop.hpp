// The proof of a k-DOP.
#pragma once

#include "fit/certify_volume.hpp"
#include "geometry/kdop_project.hpp"

namespace snug::fit {

/// A support point lies on the boundary where its projection, rounded outwards as the fitter rounds it, is a bound.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Kdop<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal) {
  const Kdop<Scalar, Dim>& kdop = fit.volume;
  const auto held_bounds = [&](const Vector<Scalar, Dim>& p) {
    unsigned held = 0;
    const auto axes = kdop_axes<Dim>(kdop.k);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (project_down<Scalar, Dim>(axes[i], p) == kdop.min[i]) held |= 1u << 2 * i;
      if (project_up<Scalar, Dim>(axes[i], p) == kdop.max[i]) held |= 2u << 2 * i;
    }
    return held;
  };
  return certify_bounds(fit, points, kdop.k, claims_optimal, held_bounds);
}

}  // namespace snug::fit
