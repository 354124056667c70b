// The proof of a result, from the returned numbers and the points alone: a test's oracle and a panel on the screen.
#pragma once

#include <optional>

#include "fit/fit.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

struct Certificate {
  bool contains = false;        // every point, in exact arithmetic
  Index outside = 0;            // how many points are not held
  double max_outside = 0;       // the farthest that one lies outside, scene units; 0 where all are held
  bool on_boundary = false;     // every support point, within rounding
  double lower_bound = 0;       // no ball with a smaller radius holds even the support; scene units
  double excess = 0;            // radius / lower_bound - 1 where the bound is positive; 0 for a ball of radius 0
  std::optional<bool> optimal;  // whether the bound meets the radius within rounding; none where nothing is claimed
};

/// claims_optimal: whether the algorithm does. The lower bound is a proof by duality: for any weights >= 0 that sum
/// to 1, the weighted variance of the points is at most the squared radius of every ball that holds them.
/// Source: K. Fischer, B. Gärtner, M. Kutz, "Fast smallest-enclosing-ball computation in high dimensions", 2003.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Sphere<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points,
                                  bool claims_optimal);

}  // namespace snug::fit
