// What the proofs of volumes have in common.
#pragma once

#include <algorithm>

#include "fit/certify.hpp"
#include "query/contain/contains.hpp"

namespace snug::fit {

/// How far the points lie outside the volume, decided exactly: what every proof begins with.
template <class VolumeType, class Scalar, int Dim>
[[nodiscard]] Certificate containment(const VolumeType& volume, PointSpan<Scalar, Dim> points) {
  Certificate certificate;
  for (const auto& p : points) {
    const double outside = query::outside_by(volume, p);
    certificate.outside += outside > 0 ? 1 : 0;
    certificate.max_outside = std::max(certificate.max_outside, outside);
  }
  certificate.contains = certificate.outside == 0;
  return certificate;
}

/// The proof of a volume that is given by its bounds. held_bounds: the bounds that a point lies on, one bit for each.
/// If a support point lies on each bound, the volume is optimal: no volume of its kind is smaller.
template <class VolumeType, class Scalar, int Dim, class Held>
[[nodiscard]] Certificate certify_bounds(const Fit<VolumeType>& fit, PointSpan<Scalar, Dim> points, int bounds,
                                         bool claims_optimal, Held held_bounds) {
  Certificate certificate = containment(fit.volume, points);
  unsigned all = 0;
  certificate.on_boundary = true;
  for (const Index i : fit.support) {
    const unsigned held = held_bounds(points[i]);
    certificate.on_boundary = certificate.on_boundary && held != 0;
    all |= held;
  }
  if (claims_optimal) certificate.optimal = certificate.contains && all == (1u << bounds) - 1;
  return certificate;
}

}  // namespace snug::fit
