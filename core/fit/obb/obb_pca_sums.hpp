// The same box as obb_pca's, watched point by point while the sums of the covariance grow; and a naive way to these
// sums. Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: a hierarchical structure for rapid interference
// detection", 1996; for the naive one I. D. Romanick, "Data Structures & Algorithms for Geometry", 2007.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_pca.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 7> kObbPcaSumsPseudocode{
    "m ← mean of the points",
    "for each point p",
    "  add (p − m)(p − m)^T to the sum",
    "C ← sum / n",
    "axes ← eigenvectors of C",
    "extents ← least and greatest along each",
    "return box",
};

inline constexpr std::array<std::string_view, 7> kObbPcaOnePassPseudocode{
    "for each point p",  //
    "  add p to s, and p p^T to the sum",
    "m ← s / n",
    "C ← sum / n − m m^T",
    "axes ← eigenvectors of C",
    "extents ← least and greatest along each",
    "return box",
};

/// The box along the principal axes, as obb_pca's to the last bit. points: n >= 1 finite points, scene units. O(n)
/// time.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_pca_sums(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = ObbStep<Scalar, Dim>;
  const MeanFound<Scalar, Dim> mean = mean_of(points, observe);
  observe(Step{0, false, {}, mean});
  const auto see = [&](Index at, const Vector<Scalar, Dim>& offset, const Matrix<Scalar, Dim>& sum) {
    if constexpr (kWatched<std::remove_reference_t<Observer>>)
      observe(Step{2, false, {}, ProductsAdded<Scalar, Dim>{at, true, offset, mirrored<Scalar, Dim>(sum)}});
  };
  const CovarianceFound<Scalar, Dim> spread = covariance_of(mean.mean, points, observe, see);
  observe(Step{3, false, {}, spread});
  return finish_on_axes(watched_axes(principal_axes(spread, points, observe), 4, observe), points, 5, observe);
}

/// The same from a covariance by the one-pass formula, mean of p p^T less m m^T. Naive: far from the origin both are
/// large and nearly equal, and their difference is rounding. The box contains every point even so, but its axes mean
/// nothing. A covariance that overflows gives the world's axes. O(n) time.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_pca_one_pass(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = ObbStep<Scalar, Dim>;
  const auto n = static_cast<Scalar>(points.size());
  Vector<Scalar, Dim> total = Vector<Scalar, Dim>::Zero();
  const auto see = [&](Index at, const Vector<Scalar, Dim>& offset, const Matrix<Scalar, Dim>& sum) {
    total += offset;
    if constexpr (kWatched<std::remove_reference_t<Observer>>)
      observe(Step{1, false, {}, ProductsAdded<Scalar, Dim>{at, false, offset, mirrored<Scalar, Dim>(sum)}});
  };
  const Vector<Scalar, Dim> origin = Vector<Scalar, Dim>::Zero();
  const Matrix<Scalar, Dim> sum = sum_of_products(origin, Scalar{1}, points, observe, see);
  const MeanFound<Scalar, Dim> mean{total / n};
  observe(Step{2, false, {}, mean});
  CovarianceFound<Scalar, Dim> spread{mean.mean, sum / n - mean.mean * mean.mean.transpose()};
  if (!spread.covariance.allFinite()) spread.covariance = Matrix<Scalar, Dim>::Identity();
  observe(Step{3, false, {}, spread});
  return finish_on_axes(watched_axes(principal_axes(spread), 4, observe), points, 5, observe);
}

}  // namespace snug::fit
