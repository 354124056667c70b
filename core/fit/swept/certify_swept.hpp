// The proofs of capsules and lozenges.
#pragma once

#include "fit/certify_volume.hpp"
#include "fit/swept/swept_radius.hpp"

namespace snug::fit {

/// A support point lies on the boundary within tolerance::kSweptBoundaryRoundoffs. Nothing proves that a capsule or a
/// lozenge is optimal.
template <class VolumeType, class Scalar, int Dim>
[[nodiscard]] Certificate certify_swept(const Fit<VolumeType>& fit, PointSpan<Scalar, Dim> points,
                                        bool claims_optimal) {
  Certificate certificate = containment(fit.volume, points);
  const double size = swept_size(fit.volume, points);
  certificate.on_boundary = std::all_of(fit.support.begin(), fit.support.end(),
                                        [&](Index i) { return touches(fit.volume, points[i], size); });
  if (claims_optimal) certificate.optimal = false;
  return certificate;
}

template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Capsule<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal) {
  return certify_swept(fit, points, claims_optimal);
}
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Lozenge<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal) {
  return certify_swept(fit, points, claims_optimal);
}

}  // namespace snug::fit
