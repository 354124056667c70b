// What each volume costs in memory.
#pragma once

#include <cstddef>

#include "geometry/aabb_forms.hpp"
#include "geometry/obb_views.hpp"
#include "geometry/volume.hpp"

namespace snug {

/// The bytes of the numbers that say what the volume is; in float, a sphere in space has 16. Of those that are the same
/// for all of a kind, as a k-DOP's axes are, none.
template <class VolumeType>
[[nodiscard]] constexpr std::size_t bytes_of(const VolumeType&) {
  return sizeof(VolumeType);
}

/// Two bounds a slab: all k of them, however many the working form has room for.
template <class Scalar, int Dim>
[[nodiscard]] constexpr std::size_t bytes_of(const Kdop<Scalar, Dim>& kdop) {
  return static_cast<std::size_t>(kdop.k) * sizeof(Scalar);
}

/// Vertices, their places in the point set, and facets.
template <class Scalar, int Dim>
[[nodiscard]] std::size_t bytes_of(const ConvexHull<Scalar, Dim>& hull) {
  return hull.vertices.size() * sizeof(Vector<Scalar, Dim>) + hull.indices.size() * sizeof(Index) +
         hull.facets.size() * sizeof(std::array<Index, Dim>);
}

}  // namespace snug
