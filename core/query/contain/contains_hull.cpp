#include "query/contain/contains_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/sphere.hpp"
#include "number/tuple.hpp"

namespace snug::query {
namespace {

template <class Scalar, int Dim>
auto corners_of(const ConvexHull<Scalar, Dim>& hull) {
  return [&hull](Index i) -> Vector<double, Dim> { return hull.vertices[i].template cast<double>(); };
}

// -- Contained or not, by affine dimension ----------------------------------------------------------------------------

template <int Dim>
bool on_segment(const Vector<double, Dim>& a, const Vector<double, Dim>& b, const Vector<double, Dim>& p) {
  const bool on_line = [&] {
    if constexpr (Dim == 2) return orient2d(a, b, p) == 0;
    else return collinear(a, b, p);
  }();
  return on_line && dot_sign<Dim>(a, b, a, p) >= 0 && dot_sign<Dim>(a, b, p, b) >= 0;
}

/// In space: whether a flat polygon contains the point, by their projections along a coordinate axis.
template <class Scalar>
bool in_flat_polygon(const ConvexHull<Scalar, 3>& hull, const Vector<double, 3>& p) {
  const auto at = corners_of(hull);
  const auto n = static_cast<Index>(hull.vertices.size());
  if (orient3d(at(0), at(1), at(2), p) != 0) return false;
  const int axis = shadow_axis(at(0), at(1), at(2));
  const bool turned = orient2d(shadow(at(0), axis), shadow(at(1), axis), shadow(at(2), axis)) < 0;
  return polygon_contains(
      n, [&](Index i) { return shadow(at(turned ? n - 1 - i : i), axis); }, shadow(p, axis));
}

template <class Scalar>
bool below_every_facet(const ConvexHull<Scalar, 3>& hull, const Vector<double, 3>& p) {
  const auto at = corners_of(hull);
  return std::none_of(hull.facets.begin(), hull.facets.end(), [&](const std::array<Index, 3>& facet) {
    return orient3d(at(facet[0]), at(facet[1]), at(facet[2]), p) > 0;
  });
}

// -- How far outside --------------------------------------------------------------------------------------------------

template <int Dim>
Vector<double, Dim> unit(const Vector<double, Dim>& v) {
  const double length = scaled_norm<double, Dim>(v);
  return length > 0 ? Vector<double, Dim>(v / length) : v;
}

Vector<double, 3> unit_normal(const Vector<double, 3>& a, const Vector<double, 3>& b, const Vector<double, 3>& c) {
  return unit<3>(cross(unit<3>(b - a), unit<3>(c - a)));
}

template <int Dim>
double outside_of_segment(const Vector<double, Dim>& a, const Vector<double, Dim>& b, const Vector<double, Dim>& p) {
  const Vector<double, Dim> along = unit<Dim>(b - a), to = p - a;
  const double reach = along.dot(to);
  return std::max({scaled_norm<double, Dim>(to - reach * along), -reach, reach - scaled_norm<double, Dim>(b - a)});
}

template <class Scalar>
double outside_of_flat_polygon(const ConvexHull<Scalar, 3>& hull, const Vector<double, 3>& p) {
  const auto at = corners_of(hull);
  const auto n = static_cast<Index>(hull.vertices.size());
  const Vector<double, 3> up = unit_normal(at(0), at(1), at(2));
  double most = std::abs(up.dot(p - at(0)));
  for (Index i = 0; i < n; ++i) {
    const Vector<double, 3> e = unit<3>(at(i + 1 < n ? i + 1 : 0) - at(i));
    const Vector<double, 3> out = cross(e, up);
    most = std::max(most, out.dot(p - at(i)));
  }
  return most;
}

double outside_of_facet(const std::array<Vector<double, 2>, 2>& edge, const Vector<double, 2>& p) {
  const Vector<double, 2> e = unit<2>(edge[1] - edge[0]);
  return e[1] * (p[0] - edge[0][0]) - e[0] * (p[1] - edge[0][1]);
}

double outside_of_facet(const std::array<Vector<double, 3>, 3>& facet, const Vector<double, 3>& p) {
  return unit_normal(facet[0], facet[1], facet[2]).dot(p - facet[0]);
}

template <class Scalar, int Dim>
double outside_of_facets(const ConvexHull<Scalar, Dim>& hull, const Vector<double, Dim>& p) {
  const auto at = corners_of(hull);
  double most = 0;
  for (const auto& facet : hull.facets) {
    std::array<Vector<double, Dim>, Dim> corners;
    std::transform(facet.begin(), facet.end(), corners.begin(), at);
    most = std::max(most, outside_of_facet(corners, p));
  }
  return most;
}

}  // namespace

template <class Scalar, int Dim>
bool contains(const ConvexHull<Scalar, Dim>& hull, const std::type_identity_t<Vector<Scalar, Dim>>& point) {
  const Vector<double, Dim> p = point.template cast<double>();
  const auto at = corners_of(hull);
  if (hull.affine_dim == 0) return at(0) == p;
  if (hull.affine_dim == 1) return on_segment<Dim>(at(0), at(1), p);
  if constexpr (Dim == 2) return polygon_contains(static_cast<Index>(hull.vertices.size()), at, p);
  else return hull.affine_dim == 2 ? in_flat_polygon(hull, p) : below_every_facet(hull, p);
}

template <class Scalar, int Dim>
double outside_by(const ConvexHull<Scalar, Dim>& hull, const std::type_identity_t<Vector<Scalar, Dim>>& point) {
  if (contains(hull, point)) return 0;
  const Vector<double, Dim> p = point.template cast<double>();
  const auto at = corners_of(hull);
  double most = std::numeric_limits<double>::infinity();
  if (hull.affine_dim == 1) most = outside_of_segment<Dim>(at(0), at(1), p);
  if (hull.affine_dim == Dim) most = outside_of_facets(hull, p);
  if constexpr (Dim == 3)
    if (hull.affine_dim == 2) most = outside_of_flat_polygon(hull, p);
  // A point is no farther from the hull than from the nearest vertex, however wrong rounding makes a sliver's normal.
  for (Index i = 0; i < static_cast<Index>(hull.vertices.size()); ++i)
    most = std::min(most, scaled_norm<double, Dim>(p - at(i)));
  // A distance that only exact arithmetic finds is smaller than the last digit of a coordinate.
  const double largest = p.cwiseAbs().maxCoeff();
  const double digit = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  return std::max(most, digit);
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template bool contains(const ConvexHull<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>&);            \
  template double outside_by(const ConvexHull<Scalar, Dim>&, const std::type_identity_t<Vector<Scalar, Dim>>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug::query
