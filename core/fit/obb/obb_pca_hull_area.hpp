// An oriented box along the principal axes of the hull's surface.
// Source: S. Gottschalk, "Collision queries using oriented bounding boxes", PhD thesis, 2000, section 4: the covariance
// of the hull's surface, integrated over its triangles. In 2-D over its edges.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "fit/obb/obb_hull.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_trials.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 6> kObbPcaHullAreaPseudocode{
    "hull ← convex hull of the points",
    "m ← centroid of its surface",
    "C ← covariance of all of its surface about m",
    "axes ← eigenvectors of C",
    "extents ← least and greatest along each",
    "return box",
};

/// The hull's surface as simplices: its facets; for a flat hull in space, the triangles of a fan; for a segment or a
/// point, itself. Each simplex is a list of vertex indices.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<std::vector<Index>> facet_corners(const ConvexHull<Scalar, Dim>& hull) {
  std::vector<std::vector<Index>> pieces;
  const auto n = static_cast<Index>(hull.vertices.size());
  for (const auto& facet : hull.facets) pieces.emplace_back(facet.begin(), facet.end());
  if (!pieces.empty()) return pieces;
  if (n == 1) return {{0}};
  if (n == 2) return {{0, 1}};
  for (Index i = 1; i + 1 < n; ++i) pieces.push_back({0, i, i + 1});
  return pieces;
}

/// The area or length in the points' units; 1 for a point.
template <int Dim>
[[nodiscard]] double size_of_piece(const std::vector<Index>& piece, const std::vector<Vector<double, Dim>>& at) {
  const auto p = [&](std::size_t k) -> const Vector<double, Dim>& { return at[piece[k]]; };
  if (piece.size() == 1) return 1;
  if (piece.size() == 2) return (p(1) - p(0)).norm();
  if constexpr (Dim == 3) return Vector<double, 3>(p(1) - p(0)).cross(Vector<double, 3>(p(2) - p(0))).norm() / 2;
  return 0;
}

/// PCA of the hull's surface, every part of it weighted by its area. Neither points inside nor the density of points on
/// the surface skew it, only the surface's shape. points: n >= 1 finite points, scene units. Expected O(n log n) time.
template <class Scalar, int Dim, StepObserver<ObbStep<Scalar, Dim>> Observer = Ignore>
Fit<Obb<Scalar, Dim>> obb_pca_hull_area(PointSpan<Scalar, Dim> points, Observer&& observe = {}) {
  using Step = ObbStep<Scalar, Dim>;
  using Point = Vector<double, Dim>;
  const ConvexHull<Scalar, Dim> hull = watched_hull(points, 0, observe);
  const LocalPoints<Dim> local(hull.vertices);
  const auto pieces = facet_corners(hull);
  const auto at = [&](Index i) -> const Point& { return local.at[i]; };
  const auto middle = [&](const std::vector<Index>& piece) {
    Point sum = Point::Zero();
    for (const Index i : piece) sum += at(i);
    return Point(sum / static_cast<double>(piece.size()));
  };

  double area = 0;
  Point mean = Point::Zero();
  for (const auto& piece : pieces) {
    const double size = size_of_piece<Dim>(piece, local.at);
    area += size;
    mean += size * middle(piece);
  }
  mean = area > 0 ? Point(mean / area) : at(0);

  // For a simplex of m vertices p with centroid c, all relative to the mean, the integral of x x^T is its size times
  // (m^2 c c^T + sum p p^T) / (m (m + 1)).
  Matrix<double, Dim> covariance = Matrix<double, Dim>::Zero();
  for (const auto& piece : pieces) {
    const auto m = static_cast<double>(piece.size());
    const Point c = m * (middle(piece) - mean);
    Matrix<double, Dim> sum = c * c.transpose();
    for (const Index i : piece) sum += (at(i) - mean) * (at(i) - mean).transpose();
    covariance += size_of_piece<Dim>(piece, local.at) / (m * (m + 1)) * sum;
  }
  if (area > 0) covariance /= area;

  const double scale = std::ldexp(1.0, local.exponent);
  const Vector<Scalar, Dim> centroid = (local.first + scale * mean).template cast<Scalar>();
  observe.count(Operation::kDotProducts, Dim * (Dim + 1) / 2 * static_cast<std::int64_t>(pieces.size()));
  observe(
      Step{1, false, {}, SurfaceFound<Scalar, Dim>{area * (pieces[0].size() == 3 ? scale * scale : scale), centroid}});
  observe(
      Step{2, false, {}, CovarianceFound<Scalar, Dim>{centroid, (covariance * scale * scale).template cast<Scalar>()}});
  const AxesFound<double, Dim> found = principal_axes(CovarianceFound<double, Dim>{mean, covariance});
  const Matrix<double, Dim> axes = right_handed<double, Dim>(orthonormal<double, Dim>(found.axes));
  const AxesFound<Scalar, Dim> in_scene{centroid, axes.template cast<Scalar>(),
                                        (found.variances * scale * scale).template cast<Scalar>()};
  observe(Step{3, false, {}, in_scene});
  return finish_on_hull<Scalar, Dim>(in_scene.axes, hull, 4, observe);
}

}  // namespace snug::fit
