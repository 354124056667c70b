#include "geometry/hull_measure.hpp"

#include <array>

#include "geometry/sphere.hpp"
#include "number/tuple.hpp"

namespace snug {
namespace {

template <int Dim>
using FacetCorners = std::array<Vector<double, Dim>, Dim>;

/// The measure of the simplex that a facet makes with the origin.
double measure_to_origin(const FacetCorners<2>& edge) {
  return (edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]) / 2;
}
double measure_to_origin(const FacetCorners<3>& facet) { return facet[0].dot(cross(facet[1], facet[2])) / 6; }

double measure_of(const FacetCorners<2>& edge) { return scaled_norm<double, 2>(edge[1] - edge[0]); }
double measure_of(const FacetCorners<3>& facet) {
  return scaled_norm<double, 3>(cross<Vector<double, 3>>(facet[1] - facet[0], facet[2] - facet[0])) / 2;
}

/// Calls visit with the vertices of each facet, relative to vertex 0; for a flat hull, with those of both its sides.
template <class Scalar, int Dim, class Visit>
void for_facets(const ConvexHull<Scalar, Dim>& hull, Visit&& visit) {
  const auto at = [&](Index i) -> Vector<double, Dim> {
    const auto& vertex = hull.vertices[i];
    return vertex.template cast<double>() - hull.vertices[0].template cast<double>();
  };
  const auto both_sides = [&](FacetCorners<Dim> corners) {
    visit(corners);
    std::swap(corners[0], corners[1]);
    visit(corners);
  };
  if constexpr (Dim == 2)
    if (hull.affine_dim == 1) both_sides({at(0), at(1)});
  if constexpr (Dim == 3)
    if (hull.affine_dim == 2)
      for (Index i = 1; i + 1 < static_cast<Index>(hull.vertices.size()); ++i) both_sides({at(0), at(i), at(i + 1)});
  for (const auto& facet : hull.facets) {
    FacetCorners<Dim> corners;
    for (std::size_t i = 0; i < Dim; ++i) corners[i] = at(facet[i]);
    visit(corners);
  }
}

}  // namespace

template <class Scalar, int Dim>
double measure(const ConvexHull<Scalar, Dim>& hull) {
  double sum = 0;
  if (hull.affine_dim == Dim)
    for_facets(hull, [&](const FacetCorners<Dim>& facet) { sum += measure_to_origin(facet); });
  return sum;
}

template <class Scalar, int Dim>
std::vector<SurfacePiece<Dim>> surface_pieces(const ConvexHull<Scalar, Dim>& hull) {
  std::vector<SurfacePiece<Dim>> pieces;
  for_facets(hull, [&](const FacetCorners<Dim>& facet) {
    Vector<double, Dim> centroid = hull.vertices[0].template cast<double>();
    for (const auto& corner : facet) centroid += corner / Dim;
    pieces.push_back({measure_of(facet), centroid});
  });
  return pieces;
}

template <class Scalar, int Dim>
double surface_measure(const ConvexHull<Scalar, Dim>& hull) {
  double sum = 0;
  for_facets(hull, [&](const FacetCorners<Dim>& facet) { sum += measure_of(facet); });
  return sum;
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template double measure(const ConvexHull<Scalar, Dim>&);                                                             \
  template std::vector<SurfacePiece<Dim>> surface_pieces(const ConvexHull<Scalar, Dim>&);                              \
  template double surface_measure(const ConvexHull<Scalar, Dim>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug
