// The way back from fit/lift.hpp: volumes in their own scalar and dimension again.
#pragma once

#include <algorithm>

#include "geometry/volume.hpp"

namespace snug::fit {

/// Calls with a lifted volume give what was lifted: nothing is lost on the way there and back.
template <class Scalar, int Dim>
struct Lower {
  using Point = Vector<Scalar, Dim>;
  static Point of(const Vector<double, 3>& v) { return v.head<Dim>().template cast<Scalar>(); }

  Sphere<Scalar, Dim> operator()(const Sphere<double, 3>& v) const {
    return {of(v.center), static_cast<Scalar>(v.radius)};
  }
  Aabb<Scalar, Dim> operator()(const Aabb<double, 3>& v) const { return {of(v.min), of(v.max)}; }
  Obb<Scalar, Dim> operator()(const Obb<double, 3>& v) const {
    return {of(v.center), v.axes.topLeftCorner<Dim, Dim>().template cast<Scalar>(), of(v.half_extents)};
  }
  Capsule<Scalar, Dim> operator()(const Capsule<double, 3>& v) const {
    return {of(v.a), of(v.b), static_cast<Scalar>(v.radius)};
  }
  Lozenge<Scalar, Dim> operator()(const Lozenge<double, 3>& v) const {
    return {of(v.origin), {of(v.edges[0]), of(v.edges[1])}, static_cast<Scalar>(v.radius)};
  }
  Kdop<Scalar, Dim> operator()(const Kdop<double, 3>& v) const {
    Kdop<Scalar, Dim> own{.k = v.k};
    for (std::size_t i = 0; i < own.min.size(); ++i)
      own.min[i] = static_cast<Scalar>(v.min[i]), own.max[i] = static_cast<Scalar>(v.max[i]);
    return own;
  }
  ConvexHull<Scalar, Dim> operator()(const ConvexHull<double, 3>& v) const {
    ConvexHull<Scalar, Dim> own{{}, v.indices, {}, v.affine_dim};
    for (const auto& vertex : v.vertices) own.vertices.push_back(of(vertex));
    own.facets.resize(v.facets.size());
    for (std::size_t i = 0; i < v.facets.size(); ++i) std::copy_n(v.facets[i].begin(), Dim, own.facets[i].begin());
    return own;
  }
};

}  // namespace snug::fit
