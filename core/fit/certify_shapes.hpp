// The proofs of boxes, swept spheres and k-DOPs.
#pragma once

#include "fit/certify.hpp"
#include "geometry/aabb.hpp"
#include "geometry/capsule.hpp"
#include "geometry/kdop.hpp"
#include "geometry/lozenge.hpp"

namespace snug::fit {

/// Containment is exact for all. A support point of a box or k-DOP lies on the boundary where it holds one of its
/// bounds exactly, but for the rounding outwards of a k-DOP's; that of a swept sphere within
/// tolerance::kSweptBoundaryRoundoffs. Optimal is a box or k-DOP each of whose bounds a support point holds so: no
/// volume of its kind is smaller then. (No capsule or lozenge is ever proven optimal.) lower_bound and excess
/// are of balls alone, and stay 0.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Aabb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Kdop<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Capsule<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Lozenge<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);

}  // namespace snug::fit
