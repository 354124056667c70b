// The ball supported by a few points, solved in twice double's digits.
#pragma once

#include <array>
#include <optional>

#include "fit/fit.hpp"
#include "geometry/point_set.hpp"
#include "geometry/sphere.hpp"
#include "number/double_double.hpp"

namespace snug::fit {

/// A ball whose centre is the weighted sum of its support points.
template <int Dim>
struct SupportBall {
  Support support;  // affinely independent
  std::array<double, Dim + 1>
      weights{};  // barycentric coordinates of the centre, in the support's order; they sum to 1
  Vector<double, Dim> center = Vector<double, Dim>::Zero();
  double radius = 0;
  DoubleDouble scaled_square;  // the squared radius is scaled_square * 4^exponent
  int exponent = 0;

  /// Whether the centre lies in the support's convex hull: then no smaller ball contains the support.
  [[nodiscard]] bool center_in_hull() const {
    for (int i = 0; i < support.size(); ++i)
      if (!(weights[i] >= 0)) return false;
    return true;
  }
};

/// Whether a's radius is smaller than b's, beyond double's digits.
template <int Dim>
[[nodiscard]] bool smaller(const SupportBall<Dim>& a, const SupportBall<Dim>& b);

/// The ball with its centre in the support's affine hull and every support point on its boundary.
/// support: 1 to Dim + 1 points. None if they are affinely dependent (tolerance::kDependentPivot).
template <class Scalar, int Dim>
[[nodiscard]] std::optional<SupportBall<Dim>> ball_through(PointSpan<Scalar, Dim> points, const Support& support);

/// The smallest ball of a few points, one of which is known to lie on its boundary: the largest ball that a subset with
/// that point supports, its centre in the subset's hull. (Each is a lower bound, and the smallest ball is one.) others:
/// at most Dim + 1 points. Larger subsets come first; one whose ball is certainly the smallest ends the search. Source:
/// B. Gärtner, "Fast and robust smallest enclosing balls", 1999, and the basis computation of
/// J. Matoušek, M. Sharir, E. Welzl, "A subexponential bound for linear programming", 1996.
template <class Scalar, int Dim>
[[nodiscard]] SupportBall<Dim> smallest_ball_with(PointSpan<Scalar, Dim> points, Index on_boundary,
                                                  const Support& others);

}  // namespace snug::fit
