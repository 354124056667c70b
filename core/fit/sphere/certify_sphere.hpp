// The proof of a sphere: containment, support and a lower bound.
#pragma once

#include "fit/certify.hpp"
#include "fit/fit.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

/// claims_optimal: whether the algorithm does. The lower bound is a proof by duality: for any weights >= 0 of sum 1,
/// the points' weighted variance is at most the squared radius of every ball that contains them.
/// Source: K. Fischer, B. Gärtner, M. Kutz, "Fast smallest-enclosing-ball computation in high dimensions", 2003.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Sphere<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);

}  // namespace snug::fit
