// The axis-aligned box around a volume of each kind, in double and rounded, for callers that need no exact box.
// query/distance/support_function.hpp has box_around for any kind.
#pragma once

#include "geometry/volume.hpp"

namespace snug {

template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Aabb<Scalar, Dim>& box) {
  return {box.min.template cast<double>(), box.max.template cast<double>()};
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_around(const Vector<Scalar, Dim>& center, const Vector<double, Dim>& reach) {
  return {center.template cast<double>() - reach, center.template cast<double>() + reach};
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Sphere<Scalar, Dim>& sphere) {
  return bounds_around<Scalar, Dim>(sphere.center, Vector<double, Dim>::Constant(static_cast<double>(sphere.radius)));
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Obb<Scalar, Dim>& box) {
  return bounds_around<Scalar, Dim>(box.center, (box.axes.cwiseAbs() * box.half_extents).template cast<double>());
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Capsule<Scalar, Dim>& capsule) {
  const Vector<double, Dim> reach = Vector<double, Dim>::Constant(static_cast<double>(capsule.radius));
  return {capsule.a.cwiseMin(capsule.b).template cast<double>() - reach,
          capsule.a.cwiseMax(capsule.b).template cast<double>() + reach};
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Lozenge<Scalar, Dim>& lozenge) {
  const Vector<double, Dim> reach = Vector<double, Dim>::Constant(static_cast<double>(lozenge.radius));
  Aabb<double, Dim> bounds{lozenge.origin.template cast<double>() - reach,
                           lozenge.origin.template cast<double>() + reach};
  for (const auto& edge : lozenge.edges) {
    bounds.min += edge.template cast<double>().cwiseMin(0.0);
    bounds.max += edge.template cast<double>().cwiseMax(0.0);
  }
  return bounds;
}
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const Kdop<Scalar, Dim>& kdop) {
  Aabb<double, Dim> bounds;  // the coordinate slabs come first
  for (std::size_t i = 0; i < Dim; ++i) {
    bounds.min[static_cast<int>(i)] = static_cast<double>(kdop.min[i]);
    bounds.max[static_cast<int>(i)] = static_cast<double>(kdop.max[i]);
  }
  return bounds;
}
/// The hull must have a vertex.
template <class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> bounds_of(const ConvexHull<Scalar, Dim>& hull) {
  Aabb<Scalar, Dim> bounds{hull.vertices.front(), hull.vertices.front()};
  for (const auto& v : hull.vertices) bounds = {bounds.min.cwiseMin(v), bounds.max.cwiseMax(v)};
  return bounds_of(bounds);
}

}  // namespace snug
