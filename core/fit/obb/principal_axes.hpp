// Mean, covariance and its eigenvectors.
// Source: X. Wu, "A linear-time simple bounding volume algorithm", Graphics Gems III, 1992.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/sphere/sphere_steps.hpp"
#include "geometry/tolerance.hpp"
#include "number/power_of_two.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// points: n >= 1. One pass, relative to the first point, so that a set far from the origin keeps its digits.
template <class Scalar, int Dim, class Observer>
MeanFound<Scalar, Dim> mean_of(PointSpan<Scalar, Dim> points, Observer& observe) {
  Vector<Scalar, Dim> sum = Vector<Scalar, Dim>::Zero();
  for (const auto& p : points) sum += p - points[0];
  observe.count(Operation::kPointsTouched, points.size());
  return {points[0] + sum / static_cast<Scalar>(points.size())};
}

/// Sees nothing.
struct SeeNoProducts {
  void operator()(Index, const auto&, const auto&) const {}
};

/// The symmetric matrix with this lower half.
template <class Scalar, int Dim>
[[nodiscard]] Matrix<Scalar, Dim> mirrored(Matrix<Scalar, Dim> lower) {
  for (int row = 0; row < Dim; ++row)
    for (int column = 0; column < row; ++column) lower(column, row) = lower(row, column);
  return lower;
}

/// The sum of (scale (p - mean)) (scale (p - mean))^T. One pass. see: receives each point's index, its offset and the
/// lower half of the sum so far.
template <class Scalar, int Dim, class Observer, class See = SeeNoProducts>
Matrix<Scalar, Dim> sum_of_products(const Vector<Scalar, Dim>& mean, Scalar scale, PointSpan<Scalar, Dim> points,
                                    Observer& observe, See see = {}) {
  Matrix<Scalar, Dim> sum = Matrix<Scalar, Dim>::Zero();
  Index at = 0;
  for (const auto& p : points) {
    const Vector<Scalar, Dim> d = scale * (p - mean);
    for (int row = 0; row < Dim; ++row)
      for (int column = 0; column <= row; ++column) sum(row, column) += d[row] * d[column];
    observe.count(Operation::kPointsTouched, 1);
    observe.count(Operation::kDotProducts, Dim * (Dim + 1) / 2);
    see(at++, d, sum);
  }
  return mirrored<Scalar, Dim>(sum);
}

/// The mean of (p - mean)(p - mean)^T. One pass; a second if the sum of the points overflows, though their mean does
/// not.
template <class Scalar, int Dim, class Observer, class See = SeeNoProducts>
CovarianceFound<Scalar, Dim> covariance_of(const Vector<Scalar, Dim>& mean, PointSpan<Scalar, Dim> points,
                                           Observer& observe, See see = {}) {
  const auto n = static_cast<Scalar>(points.size());
  const Matrix<Scalar, Dim> sum = sum_of_products(mean, Scalar{1}, points, observe, see);
  if (sum.allFinite()) return {mean, sum / n};
  constexpr auto kScale = static_cast<Scalar>(0x1p-16);  // its square offsets the largest possible number of points
  return {mean, sum_of_products(mean, kScale, points, observe) / n / (kScale * kScale)};
}

/// The principal axes of a covariance, each with its largest coordinate positive.
template <class Scalar, int Dim>
[[nodiscard]] AxesFound<Scalar, Dim> principal_axes(const CovarianceFound<Scalar, Dim>& spread);

/// The same for points so close together that their squared distances lose digits to underflow: the axes are then those
/// of the points magnified by a power of two, to the same bits, which takes two more passes.
template <class Scalar, int Dim, class Observer>
AxesFound<Scalar, Dim> principal_axes(const CovarianceFound<Scalar, Dim>& spread, PointSpan<Scalar, Dim> points,
                                      Observer& observe) {
  constexpr Scalar kRoundoff = tolerance::kRoundoff<Scalar>;
  constexpr Scalar kSound = std::numeric_limits<Scalar>::min() / kRoundoff / kRoundoff / kRoundoff;
  if (spread.covariance.cwiseAbs().maxCoeff() > kSound) return principal_axes(spread);
  Scalar largest = 0;
  for (const auto& p : points) largest = std::max(largest, Vector<Scalar, Dim>(p - spread.mean).cwiseAbs().maxCoeff());
  observe.count(Operation::kPointsTouched, points.size());
  if (largest == 0) return principal_axes(spread);
  const Scalar scale = to_unit_size(largest);
  const auto n = static_cast<Scalar>(points.size());
  const CovarianceFound<Scalar, Dim> magnified{spread.mean, sum_of_products(spread.mean, scale, points, observe) / n};
  AxesFound<Scalar, Dim> found = principal_axes(magnified);
  found.variances = (found.variances / scale / scale).eval();
  return found;
}

}  // namespace snug::fit
