// Volumes as float has them: each number rounded.
#pragma once

#include "geometry/volume.hpp"

namespace snug::desktop {

template <class From>
auto each_in_float(const From& v) { return v.template cast<float>(); }

template <int Dim>
struct ToFloat {
  using Out = Volume<float, Dim>;
  Out operator()(const Sphere<double, Dim>& v) const { return Sphere<float, Dim>{each_in_float(v.center), static_cast<float>(v.radius)}; }
  Out operator()(const Aabb<double, Dim>& v) const { return Aabb<float, Dim>{each_in_float(v.min), each_in_float(v.max)}; }
  Out operator()(const Obb<double, Dim>& v) const {
    return Obb<float, Dim>{each_in_float(v.center), each_in_float(v.axes), each_in_float(v.half_extents)};
  }
  Out operator()(const Capsule<double, Dim>& v) const {
    return Capsule<float, Dim>{each_in_float(v.a), each_in_float(v.b), static_cast<float>(v.radius)};
  }
  Out operator()(const Lozenge<double, Dim>& v) const {
    return Lozenge<float, Dim>{each_in_float(v.origin), {each_in_float(v.edges[0]), each_in_float(v.edges[1])}, static_cast<float>(v.radius)};
  }
  Out operator()(const Kdop<double, Dim>& v) const {
    Kdop<float, Dim> kdop{.k = v.k};
    for (std::size_t i = 0; i < v.min.size(); ++i)
      kdop.min[i] = static_cast<float>(v.min[i]), kdop.max[i] = static_cast<float>(v.max[i]);
    return kdop;
  }
  Out operator()(const ConvexHull<double, Dim>& v) const {
    ConvexHull<float, Dim> hull{{}, v.indices, v.facets, v.affine_dim};
    for (const auto& vertex : v.vertices) hull.vertices.push_back(each_in_float(vertex));
    return hull;
  }
};

template <int Dim>
[[nodiscard]] Volume<float, Dim> in_float(const Volume<double, Dim>& volume) { return std::visit(ToFloat<Dim>{}, volume); }

}  // namespace snug::desktop
