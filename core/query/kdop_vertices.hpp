// The corners of a k-DOP, which its slabs only imply.
#pragma once

#include <vector>

#include "geometry/kdop.hpp"
#include "geometry/vector.hpp"

namespace snug::query {

/// The corners, each once, relative to an origin (subtracted before anything is rounded, so that far k-DOPs lose no
/// digits), in scene units. Slabs that touch nothing add none; none at all where the slabs have no point in common, and
/// miss having one by more than the rounding of their bounds. Each lies in all slabs within kKdopCorner. kdop.k: one of
/// the known.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<Vector<double, Dim>>
kdop_vertices(const Kdop<Scalar, Dim>& kdop, const Vector<Scalar, Dim>& origin = Vector<Scalar, Dim>::Zero());

}  // namespace snug::query
