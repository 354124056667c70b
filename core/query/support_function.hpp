// Supporting points, and the split of a volume into a core of corners and a radius around it.
// Source: G. van den Bergen, "A fast and robust GJK implementation for collision detection of convex objects", 1999.
#pragma once

#include <limits>
#include <vector>

#include "geometry/sphere.hpp"
#include "geometry/volume.hpp"
#include "query/kdop_vertices.hpp"

namespace snug::query {

/// Some point of the volume around which coordinates are to be taken, so that far volumes lose no digits.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Sphere<Scalar, Dim>& sphere) {
  return sphere.center;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Aabb<Scalar, Dim>& box) {
  return box.min;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Obb<Scalar, Dim>& box) {
  return box.center;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Capsule<Scalar, Dim>& capsule) {
  return capsule.a;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Lozenge<Scalar, Dim>& lozenge) {
  return lozenge.origin;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Kdop<Scalar, Dim>& kdop) {
  Vector<Scalar, Dim> least;  // the first axes are those of the coordinates
  for (int i = 0; i < Dim; ++i) least[i] = kdop.min[i];
  return least;
}
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const ConvexHull<Scalar, Dim>& hull) {
  return hull.vertices.empty() ? Vector<Scalar, Dim>(Vector<Scalar, Dim>::Zero()) : hull.vertices.front();
}

/// The radius around the core: 0 of all that have corners of their own.
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Sphere<Scalar, Dim>& sphere) {
  return sphere.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Capsule<Scalar, Dim>& capsule) {
  return capsule.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Lozenge<Scalar, Dim>& lozenge) {
  return lozenge.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Aabb<Scalar, Dim>&) {
  return 0;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Obb<Scalar, Dim>&) {
  return 0;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Kdop<Scalar, Dim>&) {
  return 0;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const ConvexHull<Scalar, Dim>&) {
  return 0;
}

template <int Dim>
using Corners = std::vector<Vector<double, Dim>>;

/// a - b, rounded once.
template <class Scalar, int Dim>
[[nodiscard]] Vector<double, Dim> difference(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
  return a.template cast<double>() - b.template cast<double>();
}

/// The corners of the volume's core (a point of a sphere, a segment of a capsule, a rectangle of a lozenge, else all of
/// it) relative to an origin, in scene units. The volume is its core's convex hull grown by its core_radius. None where
/// the volume is empty: a hull without vertices, a k-DOP whose slabs do not meet.
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Sphere<Scalar, Dim>& sphere, const Vector<Scalar, Dim>& origin) {
  return {difference(sphere.center, origin)};
}
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Capsule<Scalar, Dim>& capsule, const Vector<Scalar, Dim>& origin) {
  return {difference(capsule.a, origin), difference(capsule.b, origin)};
}
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Lozenge<Scalar, Dim>& lozenge, const Vector<Scalar, Dim>& origin) {
  const Vector<double, Dim> corner = difference(lozenge.origin, origin);
  const Vector<double, Dim> e = lozenge.edges[0].template cast<double>();
  const Vector<double, Dim> f = lozenge.edges[1].template cast<double>();
  return {corner, corner + e, corner + f, corner + (e + f)};
}
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Aabb<Scalar, Dim>& box, const Vector<Scalar, Dim>& origin) {
  const Vector<double, Dim> least = difference(box.min, origin);
  const Vector<double, Dim> greatest = difference(box.max, origin);
  Corners<Dim> corners;
  for (int choice = 0; choice < (1 << Dim); ++choice) {
    Vector<double, Dim>& corner = corners.emplace_back(least);
    for (int i = 0; i < Dim; ++i)
      if ((choice >> i & 1) != 0) corner[i] = greatest[i];
  }
  return corners;
}
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Obb<Scalar, Dim>& box, const Vector<Scalar, Dim>& origin) {
  const Vector<double, Dim> center = difference(box.center, origin);
  const Matrix<double, Dim> edges =
      box.axes.template cast<double>() * box.half_extents.template cast<double>().asDiagonal();
  Corners<Dim> corners;
  for (int choice = 0; choice < (1 << Dim); ++choice) {
    Vector<double, Dim> arm = Vector<double, Dim>::Zero();  // summed by itself, so that opposite corners are opposite
    for (int i = 0; i < Dim; ++i) arm += edges.col(i) * ((choice >> i & 1) != 0 ? 1 : -1);
    corners.push_back(center + arm);
  }
  return corners;
}
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Kdop<Scalar, Dim>& kdop, const Vector<Scalar, Dim>& origin) {
  return kdop_vertices(kdop, origin);
}
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const ConvexHull<Scalar, Dim>& hull, const Vector<Scalar, Dim>& origin) {
  Corners<Dim> corners;
  corners.reserve(hull.vertices.size());
  for (const auto& vertex : hull.vertices) corners.push_back(difference(vertex, origin));
  return corners;
}

/// The corner farthest along a direction; the first of several. corners: at least one.
template <int Dim>
[[nodiscard]] std::size_t farthest_corner(const Corners<Dim>& corners, const Vector<double, Dim>& direction) {
  std::size_t farthest = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double reach = corners[i].dot(direction);
    if (reach > most) most = reach, farthest = i;
  }
  return farthest;
}

/// A point of the volume farthest along a direction, within rounding. direction: any but zero, need not be unit. The
/// volume must not be empty.
template <template <class, int> class Volume, class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> support(const Volume<Scalar, Dim>& volume,
                                          const std::type_identity_t<Vector<Scalar, Dim>>& direction) {
  const Vector<Scalar, Dim> origin = anchor(volume);
  const Corners<Dim> corners = core_corners(volume, origin);
  const Vector<double, Dim> towards =
      direction.template cast<double>() / direction.template cast<double>().cwiseAbs().maxCoeff();
  const Vector<double, Dim> point = corners[farthest_corner<Dim>(corners, towards)] +
                                    static_cast<double>(core_radius(volume)) / towards.norm() * towards;
  return (origin.template cast<double>() + point).template cast<Scalar>();
}

}  // namespace snug::query
