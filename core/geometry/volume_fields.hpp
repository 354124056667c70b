// Each volume's fields as files and scripts know them, to be written and to be read: as they stand in its header, but
// for what is said otherwise here.
#pragma once

#include <span>
#include <vector>

#include "geometry/volume.hpp"
#include "trace/fields.hpp"

namespace snug {

template <template <class, int> class Kind, class Scalar, int Dim>
requires Listed<Kind<Scalar, Dim>>
void fields_of(const Kind<Scalar, Dim>& volume, auto&& see) { see_fields(volume, see); }

/// Calls see(name, field) for each field that a file may set, in order.
template <template <class, int> class Kind, class Scalar, int Dim>
void fields_to_read(Kind<Scalar, Dim>& volume, auto&& see) {
  see_fields(volume, see);
}

/// The axes as rows.
template <class Scalar, int Dim>
void fields_of(const Obb<Scalar, Dim>& box, auto&& see) {
  const Matrix<Scalar, Dim> rows = box.axes.transpose();
  see("center", box.center);
  see("axes", rows);
  see("half_extents", box.half_extents);
}

template <class Scalar, int Dim>
void fields_of(const Lozenge<Scalar, Dim>& lozenge, auto&& see) {
  const std::vector<Vector<Scalar, Dim>> edges(lozenge.edges.begin(), lozenge.edges.end());
  see("origin", lozenge.origin);
  see("edges", edges);
  see("radius", lozenge.radius);
}

/// The bounds that are used.
template <class Scalar, int Dim>
void fields_of(const Kdop<Scalar, Dim>& kdop, auto&& see) {
  const std::size_t slabs = kdop.k / 2;
  const std::vector<Scalar> min(kdop.min.begin(), kdop.min.begin() + slabs),
      max(kdop.max.begin(), kdop.max.begin() + slabs);
  see("k", kdop.k);
  see("min", min);
  see("max", max);
}

/// Only the vertices: everything else follows from them.
template <class Scalar, int Dim>
void fields_of(const ConvexHull<Scalar, Dim>& hull, auto&& see) {
  see("points", hull.vertices);
}
template <class Scalar, int Dim>
void fields_to_read(ConvexHull<Scalar, Dim>& hull, auto&& see) {
  see("points", hull.vertices);
}

}  // namespace snug
