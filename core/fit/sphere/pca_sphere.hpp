// A sphere through the two extreme points along the principal axis, which grows until it contains all points.
// Source: X. Wu, "A linear-time simple bounding volume algorithm", Graphics Gems III, 1992; the growing pass is
// Ritter's.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/principal_axes.hpp"
#include "fit/sphere/ritter.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 9> kPcaSpherePseudocode{
    "m ← mean of the points",
    "C ← covariance about m",
    "v ← eigenvector of largest eigenvalue",
    "find the extreme points along v",
    "S ← those two as diameter",
    "for each point p",
    "  if p lies outside S: grow S to p",
    "test all points, exactly",
    "return S",
};

/// Ritter's sphere with its first ball along the direction of greatest spread.
/// points: n >= 1 finite points, scene units. O(n) time: four passes, and one that tests the result exactly.
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> pca_sphere(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = SphereStep<Scalar, Dim>;
  const MeanFound<Scalar, Dim> mean = mean_of(points, observe);
  observe(Step{0, false, {}, mean});
  const CovarianceFound<Scalar, Dim> covariance = covariance_of(mean.mean, points, observe);
  observe(Step{1, false, {}, covariance});
  const AxesFound<Scalar, Dim> axes = principal_axes(covariance);
  observe(Step{2, false, {}, axes});

  const Vector<Scalar, Dim> main = axes.axes.col(Dim - 1);
  const DirectionExtremes ends = extreme_points_along(main, mean.mean, points, observe);
  const Sphere<Scalar, Dim> ball = ball_on_diameter<Scalar, Dim>(points[ends.least], points[ends.greatest]);
  const PairChosen pair{ends.least, ends.greatest, kNoIndex, 2 * static_cast<double>(ball.radius)};
  observe(Step{3, false, {}, pair});
  observe(Step{4, true, ball, pair});
  return grow_over_all(ball, {ends.least, ends.greatest}, points, 5, observe);
}

}  // namespace snug::fit
