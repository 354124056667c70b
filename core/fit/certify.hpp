// Proves a result from the returned numbers and the points alone. Tests use it as their oracle, and a panel shows it.
#pragma once

#include <optional>

#include "fit/fit.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

struct Certificate {
  bool contains = false;        // every point, in exact arithmetic
  Index outside = 0;            // how many points it does not contain
  double max_outside = 0;       // the farthest that any point lies outside, scene units; 0 if all are inside
  bool on_boundary = false;     // every support point, within rounding
  double lower_bound = 0;       // no smaller ball contains even the support set; scene units
  double excess = 0;            // radius / lower_bound - 1 where the bound is positive; 0 for a ball of radius 0
  std::optional<bool> optimal;  // whether radius and bound agree within rounding; none if optimality is not claimed
};

/// claims_optimal: whether the algorithm does. The lower bound is a proof by duality: for any weights >= 0 of sum 1,
/// the points' weighted variance is at most the squared radius of every ball that contains them.
/// Source: K. Fischer, B. Gärtner, M. Kutz, "Fast smallest-enclosing-ball computation in high dimensions", 2003.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Sphere<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);

}  // namespace snug::fit
