// Each volume's fields by the names that files and scripts know, listed once for every reader and writer.
#pragma once

#include <span>
#include <vector>

#include "geometry/volume.hpp"

namespace snug {

template <class Scalar, int Dim>
void fields_of(const Sphere<Scalar, Dim>& sphere, auto&& see) {
  see("center", sphere.center), see("radius", sphere.radius);
}

template <class Scalar, int Dim>
void fields_of(const Aabb<Scalar, Dim>& box, auto&& see) {
  see("min", box.min), see("max", box.max);
}

/// The axes as rows.
template <class Scalar, int Dim>
void fields_of(const Obb<Scalar, Dim>& box, auto&& see) {
  Matrix<Scalar, Dim> rows = Matrix<Scalar, Dim>::Zero();
  rows = box.axes.transpose();
  see("center", box.center), see("axes", rows), see("half_extents", box.half_extents);
}

template <class Scalar, int Dim>
void fields_of(const Capsule<Scalar, Dim>& capsule, auto&& see) {
  see("a", capsule.a), see("b", capsule.b), see("radius", capsule.radius);
}

template <class Scalar, int Dim>
void fields_of(const Lozenge<Scalar, Dim>& lozenge, auto&& see) {
  const std::vector<Vector<Scalar, Dim>> edges(lozenge.edges.begin(), lozenge.edges.end());
  see("origin", lozenge.origin), see("edges", edges), see("radius", lozenge.radius);
}

template <class Scalar, int Dim>
void fields_of(const Kdop<Scalar, Dim>& kdop, auto&& see) {
  const auto slabs = static_cast<std::size_t>(kdop.k / 2);
  const std::vector<Scalar> min(kdop.min.begin(), kdop.min.begin() + slabs),
      max(kdop.max.begin(), kdop.max.begin() + slabs);
  see("k", kdop.k), see("min", min), see("max", max);
}

template <class Scalar, int Dim>
void fields_of(const ConvexHull<Scalar, Dim>& hull, auto&& see) {
  see("points", hull.vertices);
}

}  // namespace snug
