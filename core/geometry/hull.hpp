// The convex hull, as a polygon (2-D) or a closed surface of triangles (3-D).
#pragma once

#include <array>
#include <vector>

#include "geometry/core.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// Vertices are points of the set, unrounded: in 2-D counter-clockwise around it, in 3-D by rising index. facets hold
/// indices into vertices: in 2-D edges, facet i from vertex i to the next; in 3-D triangles, counter-clockwise as seen
/// from outside. If the points span fewer than Dim dimensions (affine_dim), the hull is a point, a segment's two ends,
/// or in 3-D a flat polygon's vertices in their order around it, and facets is empty.
template <class Scalar, int Dim>
struct ConvexHull {
  std::vector<Vector<Scalar, Dim>> vertices;
  std::vector<Index> indices;  // each vertex's index in the point set
  std::vector<std::array<Index, Dim>> facets;
  int affine_dim = Dim;
  SNUG_FIELDS(vertices, indices, facets, affine_dim);
};

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const ConvexHull<Scalar, Dim>& hull) {
  return hull.vertices.empty() ? Vector<Scalar, Dim>(Vector<Scalar, Dim>::Zero()) : hull.vertices.front();
}

template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const ConvexHull<Scalar, Dim>& hull, const Vector<Scalar, Dim>& origin) {
  Corners<Dim> corners;
  corners.reserve(hull.vertices.size());
  for (const auto& vertex : hull.vertices) corners.push_back(difference(vertex, origin));
  return corners;
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const ConvexHull<Scalar, Dim>& hull) {
  Span<Number> span = core_span<Number>(plane, hull.vertices.front());
  for (const auto& vertex : hull.vertices) {
    const Number value = value_at<Number>(plane, vertex);
    if (value < span.low) span.low = value;
    if (span.high < value) span.high = value;
  }
  return span;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const ConvexHull<Scalar, Dim>& hull) {
  Scalar most = 0;
  for (const auto& vertex : hull.vertices) most = std::max(most, largest<Scalar, Dim>(vertex));
  return most;
}

template <class Scalar, int Dim>
[[nodiscard]] ConvexHull<Scalar, Dim> moved(ConvexHull<Scalar, Dim> hull, const Vector<Scalar, Dim>& by) {
  for (auto& vertex : hull.vertices) vertex += by;
  return hull;
}
/// About the mean of its vertices.
template <class Scalar, int Dim>
[[nodiscard]] ConvexHull<Scalar, Dim> turned(ConvexHull<Scalar, Dim> hull, const Matrix<Scalar, Dim>& rotation) {
  Vector<Scalar, Dim> middle = Vector<Scalar, Dim>::Zero();
  for (const auto& vertex : hull.vertices) middle += vertex / static_cast<Scalar>(hull.vertices.size());
  for (auto& vertex : hull.vertices) vertex = middle + rotation * (vertex - middle);
  return hull;
}

}  // namespace snug
