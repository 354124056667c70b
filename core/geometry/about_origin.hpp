// A volume as a program updates it: moved by a vector, turned about the world's origin, grown by a margin, in each form
// that it may be stored in. (The volumes' own headers have `moved`, and `turned` about their middle.) Every function is
// a template over its numbers, so that Counted (counted.hpp) tells what it takes.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.2 to 4.6.
//
// There is no overload where the numbers alone do not tell the result: an axis-aligned box or a k-DOP that turns has to
// be fitted anew, and a box that is stored as its vertices knows no axes to grow along.
#pragma once

#include <cmath>
#include <type_traits>

#include "geometry/aabb_forms.hpp"
#include "geometry/obb_views.hpp"
#include "geometry/volume.hpp"

namespace snug {

// ---- moved by a vector: the forms that are no volumes of their own

template <class Scalar, int Dim>
[[nodiscard]] AabbMinWidths<Scalar, Dim> moved(const AabbMinWidths<Scalar, Dim>& box, const Vector<Scalar, Dim>& by) {
  return {box.min + by, box.widths};
}
template <class Scalar, int Dim>
[[nodiscard]] AabbCenterExtents<Scalar, Dim> moved(const AabbCenterExtents<Scalar, Dim>& box,
                                                   const Vector<Scalar, Dim>& by) {
  return {box.center + by, box.half_extents};
}
template <class Scalar, int Dim>
[[nodiscard]] ObbVertices<Scalar, Dim> moved(ObbVertices<Scalar, Dim> vertices, const Vector<Scalar, Dim>& by) {
  for (auto& vertex : vertices) vertex += by;
  return vertices;
}
template <class Scalar, int Dim>
[[nodiscard]] ObbPlanes<Scalar, Dim> moved(ObbPlanes<Scalar, Dim> planes, const Vector<Scalar, Dim>& by) {
  for (auto& plane : planes) plane.d -= plane.normal.dot(by);
  return planes;
}
template <class Scalar, int Dim>
[[nodiscard]] ObbSlabs<Scalar, Dim> moved(ObbSlabs<Scalar, Dim> slabs, const Vector<Scalar, Dim>& by) {
  for (auto& slab : slabs) {
    const Scalar along = slab.normal.dot(by);
    slab.min += along;
    slab.max += along;
  }
  return slabs;
}

// ---- turned about the origin

template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> turned_about_origin(const Sphere<Scalar, Dim>& sphere,
                                                      const Matrix<Scalar, Dim>& rotation) {
  return {turned<Scalar, Dim>(rotation, sphere.center), sphere.radius};
}
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> turned_about_origin(const Obb<Scalar, Dim>& box, const Matrix<Scalar, Dim>& rotation) {
  return {turned<Scalar, Dim>(rotation, box.center), rotation * box.axes, box.half_extents};
}
template <class Scalar, int Dim>
[[nodiscard]] Capsule<Scalar, Dim> turned_about_origin(const Capsule<Scalar, Dim>& capsule,
                                                       const Matrix<Scalar, Dim>& rotation) {
  return {turned<Scalar, Dim>(rotation, capsule.a), turned<Scalar, Dim>(rotation, capsule.b), capsule.radius};
}
template <class Scalar, int Dim>
[[nodiscard]] Lozenge<Scalar, Dim> turned_about_origin(const Lozenge<Scalar, Dim>& lozenge,
                                                       const Matrix<Scalar, Dim>& rotation) {
  return {turned<Scalar, Dim>(rotation, lozenge.origin),
          {rotation * lozenge.edges[0], rotation * lozenge.edges[1]},
          lozenge.radius};
}
template <class Scalar, int Dim>
[[nodiscard]] ObbVertices<Scalar, Dim> turned_about_origin(ObbVertices<Scalar, Dim> vertices,
                                                           const Matrix<Scalar, Dim>& rotation) {
  for (auto& vertex : vertices) vertex = turned<Scalar, Dim>(rotation, vertex);
  return vertices;
}
template <class Scalar, int Dim>
[[nodiscard]] ObbPlanes<Scalar, Dim> turned_about_origin(ObbPlanes<Scalar, Dim> planes,
                                                         const Matrix<Scalar, Dim>& rotation) {
  for (auto& plane : planes) plane.normal = turned<Scalar, Dim>(rotation, plane.normal);
  return planes;
}
template <class Scalar, int Dim>
[[nodiscard]] ObbSlabs<Scalar, Dim> turned_about_origin(ObbSlabs<Scalar, Dim> slabs,
                                                        const Matrix<Scalar, Dim>& rotation) {
  for (auto& slab : slabs) slab.normal = turned<Scalar, Dim>(rotation, slab.normal);
  return slabs;
}

// ---- with its body

/// A volume that is fitted once, and then turns and moves with its body.
template <template <class, int> class Kind, class Scalar, int Dim>
requires requires(const Kind<Scalar, Dim>& volume, const Matrix<Scalar, Dim>& rotation) {
  turned_about_origin(volume, rotation);
}
[[nodiscard]] Kind<Scalar, Dim> posed(const Kind<Scalar, Dim>& volume, const Pose<Scalar, Dim>& pose) {
  Kind<Scalar, Dim> there = moved(turned_about_origin(volume, pose.rotation), pose.translation);
  // However often it turns, its axes stay unit and perpendicular.
  if constexpr (requires { there.axes; }) there.axes = orthonormal<Scalar, Dim>(there.axes);
  return there;
}
template <class Scalar, int Dim>
[[nodiscard]] ConvexHull<Scalar, Dim> posed(ConvexHull<Scalar, Dim> hull, const Pose<Scalar, Dim>& pose) {
  for (auto& vertex : hull.vertices) vertex = placed(pose, vertex);
  return hull;
}

/// Whether volumes of a kind can be posed. AABBs and k-DOPs have axes of their own, and must be fitted anew.
template <class Kind>
inline constexpr bool kRotatesWithBody = false;
template <template <class, int> class Kind, class Scalar, int Dim>
inline constexpr bool kRotatesWithBody<Kind<Scalar, Dim>> = requires(const Kind<Scalar, Dim>& volume,
                                                                     const Pose<Scalar, Dim>& pose) {
  posed(volume, pose);
};

// ---- grown by a margin on every side

template <class Scalar, int Dim>
[[nodiscard]] Aabb<Scalar, Dim> grown(const Aabb<Scalar, Dim>& box, std::type_identity_t<Scalar> by) {
  const auto every_side = Vector<Scalar, Dim>::Constant(by);
  return {box.min - every_side, box.max + every_side};
}
template <class Scalar, int Dim>
[[nodiscard]] AabbMinWidths<Scalar, Dim> grown(const AabbMinWidths<Scalar, Dim>& box, std::type_identity_t<Scalar> by) {
  const Scalar twice = by + by;
  return {box.min - Vector<Scalar, Dim>::Constant(by), box.widths + Vector<Scalar, Dim>::Constant(twice)};
}
template <class Scalar, int Dim>
[[nodiscard]] AabbCenterExtents<Scalar, Dim> grown(const AabbCenterExtents<Scalar, Dim>& box,
                                                   std::type_identity_t<Scalar> by) {
  return {box.center, box.half_extents + Vector<Scalar, Dim>::Constant(by)};
}
template <class Scalar, int Dim, std::size_t planes>
[[nodiscard]] std::array<Plane<Scalar, Dim>, planes> grown(std::array<Plane<Scalar, Dim>, planes> all,
                                                           std::type_identity_t<Scalar> by) {
  for (auto& plane : all) plane.d -= by;
  return all;
}
template <class Scalar, int Dim, std::size_t slabs>
[[nodiscard]] std::array<Slab<Scalar, Dim>, slabs> grown(std::array<Slab<Scalar, Dim>, slabs> all,
                                                         std::type_identity_t<Scalar> by) {
  for (auto& slab : all) {
    slab.min -= by;
    slab.max += by;
  }
  return all;
}
template <class Scalar, int Dim>
[[nodiscard]] Obb<Scalar, Dim> grown(const Obb<Scalar, Dim>& box, std::type_identity_t<Scalar> by) {
  return {box.center, box.axes, box.half_extents + Vector<Scalar, Dim>::Constant(by)};
}
/// A sphere, a capsule or a lozenge: its radius grows.
template <template <class, int> class Kind, class Scalar, int Dim>
requires requires(Kind<Scalar, Dim>& swept, const Scalar& by) { swept.radius += by; }
[[nodiscard]] Kind<Scalar, Dim> grown(Kind<Scalar, Dim> swept, std::type_identity_t<Scalar> by) {
  swept.radius += by;
  return swept;
}
/// The axes are not unit: along an axis with two nonzero coordinates the bounds move by sqrt(2) times the margin, with
/// three by sqrt(3) times.
template <class Scalar, int Dim>
[[nodiscard]] Kdop<Scalar, Dim> grown(Kdop<Scalar, Dim> kdop, std::type_identity_t<Scalar> by) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    int square = 0;
    for (const int entry : axes[i]) square += entry * entry;
    const Scalar along = square > 1 ? by * static_cast<Scalar>(std::sqrt(static_cast<double>(square))) : by;
    kdop.min[i] -= along;
    kdop.max[i] += along;
  }
  return kdop;
}

}  // namespace snug
