// An oriented box along the principal axes of the hull's vertices.
// Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: a hierarchical structure for rapid interference detection",
// 1996, who take the hull's vertices in place of all points.
#pragma once

#include <array>
#include <string_view>

#include "fit/obb/obb_hull.hpp"
#include "fit/obb/obb_pca.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kObbPcaHullPseudocode{
    "hull ← convex hull of the points",
    "m ← mean of its vertices",
    "C ← their covariance about m",
    "axes ← eigenvectors of C",
    "extents ← least and greatest along each",
    "return box",
};

/// PCA of the hull's vertices: points inside skew it no more, but dense vertices still do.
/// points: n >= 1 finite points, scene units. Expected O(n log n) time.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_pca_hull(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  const PointSet<Scalar, Dim> vertices = vertices_of(hull);
  const Matrix<Scalar, Dim> axes = watched_principal_axes(vertices.span(), 1, observe);
  return finish_on_hull(axes, hull, 4, observe);
}

}  // namespace snug::fit
