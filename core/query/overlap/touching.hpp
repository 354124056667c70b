// Tells touching from overlapping, where that can be decided without rounding.
#pragma once

#include <optional>

#include "geometry/volume.hpp"

namespace snug::query {

/// Whether two volumes share points, and yet some move, however short, parts them. Exact on the numbers as they are;
/// none for pairs that only rounded arithmetic knows: all but those of spheres, AABBs and OBBs, a sphere with an OBB,
/// and an AABB whose centre rounds with an OBB.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<bool> touch(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);

}  // namespace snug::query
