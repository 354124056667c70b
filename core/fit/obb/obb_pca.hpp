// An oriented box along the principal axes of the points.
// Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: a hierarchical structure for rapid interference detection",
// 1996.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_frame.hpp"
#include "fit/obb/obb_from_axes.hpp"
#include "fit/obb/principal_axes.hpp"
#include "geometry/pose.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 5> kObbPcaPseudocode{
    "m ← mean of the points",
    "C ← covariance about m",
    "axes ← eigenvectors of C",
    "extents ← least and greatest along each",
    "return box",
};

/// Principal axes as those of a box, right-handed, as one step.
template <class Scalar, int Dim, class Observer>
Matrix<Scalar, Dim> watched_axes(AxesFound<Scalar, Dim> found, int line, Observer& observe) {
  // The eigenvectors are perpendicular to a few digits fewer than a box's axes have to be.
  const Matrix<double, Dim> axes = orthonormal<double, Dim>(found.axes.template cast<double>());
  found.axes = right_handed<double, Dim>(axes).template cast<Scalar>();
  observe(ObbStep<Scalar, Dim>{line, false, {}, found});
  return found.axes;
}

/// Mean, covariance and principal axes, right-handed, as three steps from the given line of the pseudocode on.
template <class Scalar, int Dim, class Observer>
Matrix<Scalar, Dim> watched_principal_axes(PointSpan<Scalar, Dim> points, int line, Observer& observe) {
  using Step = ObbStep<Scalar, Dim>;
  const MeanFound<Scalar, Dim> mean = mean_of(points, observe);
  observe(Step{line, false, {}, mean});
  const CovarianceFound<Scalar, Dim> spread = covariance_of(mean.mean, points, observe);
  observe(Step{line + 1, false, {}, spread});
  return watched_axes(principal_axes(spread, points, observe), line + 2, observe);
}

/// The box along the directions in which the points spread most and least. Dense clusters of points skew it, whether
/// inside or on the surface. points: n >= 1 finite points, scene units. O(n) time: three passes.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_pca(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  const Matrix<Scalar, Dim> axes = watched_principal_axes(points, 0, observe);
  return finish_on_axes(axes, points, 3, observe);
}

}  // namespace snug::fit
