// Other representations of the oriented box, which is not stored as these: vertices, faces, slabs.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 4.4.
#pragma once

#include <array>

#include "geometry/obb.hpp"
#include "geometry/plane.hpp"

namespace snug {

/// All p with min <= p . normal <= max: the space between two parallel planes.
/// Source: T. L. Kay, J. T. Kajiya, "Ray tracing complex scenes", 1986.
template <class Scalar, int Dim>
struct Slab {
  Vector<Scalar, Dim> normal = Vector<Scalar, Dim>::Zero();
  Scalar min = 0;
  Scalar max = 0;
};

template <class Scalar, int Dim>
using ObbVertices = std::array<Vector<Scalar, Dim>, std::size_t{1} << Dim>;
template <class Scalar, int Dim>
using ObbPlanes = std::array<Plane<Scalar, Dim>, std::size_t{2} * Dim>;
template <class Scalar, int Dim>
using ObbSlabs = std::array<Slab<Scalar, Dim>, std::size_t{Dim}>;

/// Vertex v is on the positive side of axis i if bit i of v is set. Each coordinate is rounded from its value in
/// double.
template <class Scalar, int Dim>
[[nodiscard]] ObbVertices<Scalar, Dim> vertices_of(const Obb<Scalar, Dim>& box) {
  ObbVertices<Scalar, Dim> vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    Vector<double, Dim> vertex = box.center.template cast<double>();
    for (int i = 0; i < Dim; ++i) {
      const double half_extent = static_cast<double>(box.half_extents[i]);
      vertex += (v >> i & 1 ? half_extent : -half_extent) * box.axes.col(i).template cast<double>();
    }
    vertices[v] = vertex.template cast<Scalar>();
  }
  return vertices;
}

/// The slabs by axis. They are the tightest around the box that the Scalar allows: in exact arithmetic every slab
/// contains the box, and no bound could be the next number inwards. Coordinates and half extents finite, up to
/// PointSet's largest.
template <class Scalar, int Dim>
[[nodiscard]] ObbSlabs<Scalar, Dim> slabs_of(const Obb<Scalar, Dim>& box);

/// The planes of axis i: first the face on its positive side, then the one on its negative side. As tight as the slabs.
template <class Scalar, int Dim>
[[nodiscard]] ObbPlanes<Scalar, Dim> planes_of(const Obb<Scalar, Dim>& box) {
  ObbPlanes<Scalar, Dim> planes;
  const auto slabs = slabs_of(box);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    planes[2 * i] = {slabs[i].normal, -slabs[i].max};
    planes[2 * i + 1] = {-slabs[i].normal, slabs[i].min};
  }
  return planes;
}

}  // namespace snug
