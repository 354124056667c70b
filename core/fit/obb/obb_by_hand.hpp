// The box whose axes are set by hand.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_from_axes.hpp"
#include "fit/obb/principal_axes.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kObbByHandPseudocode{
    "axes ← set by hand",
    "extents ← least and greatest along each",
    "return box",
};

/// The smallest box with the given axes. axes: unit, perpendicular and right-handed within rounding. points: n >= 1
/// finite points, scene units. O(n) time: one pass.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_by_hand(PointSpan<Scalar, Dim> points, const Matrix<Scalar, Dim>& axes,
                                  Observer&& observe = {}) {
  return finish_on_axes<Scalar, Dim>(axes, points, 1, observe);
}

inline constexpr std::array<std::string_view, 5> kObbEigenByHandPseudocode{
    "m ← mean of the points",
    "C ← covariance about m",
    "v ← set by hand; turn it until C v lies along v",
    "extents ← least and greatest along v and across",
    "return box",
};

/// The same box, after a step that shows the covariance, of which the first axis may be an eigenvector. Three passes.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_eigen_by_hand(PointSpan<Scalar, Dim> points, const Matrix<Scalar, Dim>& axes,
                                        Observer&& observe = {}) {
  using Step = ObbStep<Scalar, Dim>;
  const MeanFound<Scalar, Dim> mean = mean_of(points, observe);
  observe(Step{0, false, {}, mean});
  observe(Step{1, false, {}, covariance_of(mean.mean, points, observe)});
  return finish_on_axes<Scalar, Dim>(axes, points, 3, observe);
}

}  // namespace snug::fit
