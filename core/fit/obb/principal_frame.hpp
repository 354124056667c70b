// Points in the frame of their principal axes; the capsule and the lozenge fitters share it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fit/obb/principal_axes.hpp"
#include "geometry/pose.hpp"
#include "number/power_of_two.hpp"

namespace snug::fit {

/// Coordinates along unit axes from an origin, scaled by a power of two so that the points are of about unit size: no
/// square of them over- or underflows to any effect.
template <class Scalar, int Dim>
struct PrincipalFrame {
  Vector<Scalar, Dim> origin;
  Matrix<Scalar, Dim> axes;  // by rising variance
  Scalar scale;
  std::vector<Vector<Scalar, Dim>> local;  // each point in the frame

  /// An offset in the frame as one in the scene.
  [[nodiscard]] Vector<Scalar, Dim> to_scene(const Vector<Scalar, Dim>& offset) const {
    return turned<Scalar, Dim>(axes, offset) / scale;
  }
};

/// Computes mean, covariance and axes, as three steps from line 0 of the pseudocode on; then the points. Four passes.
template <class StepType, class Scalar, int Dim, class Observer>
[[nodiscard]] PrincipalFrame<Scalar, Dim> principal_frame(PointSpan<Scalar, Dim> points, Observer& observe) {
  const MeanFound<Scalar, Dim> mean = mean_of(points, observe);
  observe(StepType{0, false, {}, mean});
  const CovarianceFound<Scalar, Dim> spread = covariance_of(mean.mean, points, observe);
  observe(StepType{1, false, {}, spread});
  AxesFound<Scalar, Dim> found = principal_axes(spread, points, observe);
  found.axes = orthonormal<Scalar, Dim>(found.axes);
  observe(StepType{2, false, {}, found});

  Scalar largest = 0;
  for (const auto& p : points) largest = std::max(largest, Vector<Scalar, Dim>(p - mean.mean).cwiseAbs().maxCoeff());
  PrincipalFrame<Scalar, Dim> frame{mean.mean, found.axes, to_unit_size(largest), {}};
  frame.local.reserve(points.size());
  for (const auto& p : points)
    frame.local.push_back(turned_back<Scalar, Dim>(found.axes, (p - mean.mean) * frame.scale));
  observe.count(Operation::kPointsTouched, 2 * std::int64_t{points.size()});
  observe.count(Operation::kDotProducts, Dim * std::int64_t{points.size()});
  return frame;
}

}  // namespace snug::fit
