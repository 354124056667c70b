// Volumes as float has them: each number rounded, bounds, half extents and radii outward, so that no box or k-DOP loses
// a point.
#pragma once

#include <cmath>
#include <limits>

#include "geometry/volume.hpp"

namespace snug::desktop {

template <class From>
auto each_in_float(const From& v) {
  return v.template cast<float>();
}

/// The least float that is not below the value.
inline float float_above(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                                              : nearest;
}
inline float float_below(double value) { return -float_above(-value); }

template <int Dim>
struct ToFloat {
  using Out = Volume<float, Dim>;
  Out operator()(const Sphere<double, Dim>& v) const {
    return Sphere<float, Dim>{each_in_float(v.center), float_above(v.radius)};
  }
  Out operator()(const Aabb<double, Dim>& v) const {
    return Aabb<float, Dim>{v.min.unaryExpr(&float_below), v.max.unaryExpr(&float_above)};
  }
  Out operator()(const Obb<double, Dim>& v) const {
    return Obb<float, Dim>{each_in_float(v.center), each_in_float(v.axes), v.half_extents.unaryExpr(&float_above)};
  }
  Out operator()(const Capsule<double, Dim>& v) const {
    return Capsule<float, Dim>{each_in_float(v.a), each_in_float(v.b), float_above(v.radius)};
  }
  Out operator()(const Lozenge<double, Dim>& v) const {
    return Lozenge<float, Dim>{
        each_in_float(v.origin), {each_in_float(v.edges[0]), each_in_float(v.edges[1])}, float_above(v.radius)};
  }
  Out operator()(const Kdop<double, Dim>& v) const {
    Kdop<float, Dim> kdop{.k = v.k};
    for (std::size_t i = 0; i < v.min.size(); ++i)
      kdop.min[i] = float_below(v.min[i]), kdop.max[i] = float_above(v.max[i]);
    return kdop;
  }
  Out operator()(const ConvexHull<double, Dim>& v) const {
    ConvexHull<float, Dim> hull{{}, v.indices, v.facets, v.affine_dim};
    for (const auto& vertex : v.vertices) hull.vertices.push_back(each_in_float(vertex));
    return hull;
  }
};

template <int Dim>
[[nodiscard]] Volume<float, Dim> in_float(const Volume<double, Dim>& volume) {
  return std::visit(ToFloat<Dim>{}, volume);
}

}  // namespace snug::desktop
