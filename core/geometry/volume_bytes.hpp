// What each volume costs in memory.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "geometry/aabb_forms.hpp"
#include "geometry/obb_views.hpp"
#include "geometry/volume.hpp"
#include "trace/fields.hpp"

namespace snug {

template <class Plain>
[[nodiscard]] constexpr std::size_t bytes_of_field(const Plain&) {
  return sizeof(Plain);
}
template <class Item>
[[nodiscard]] std::size_t bytes_of_field(const std::vector<Item>& items) {
  return items.size() * sizeof(Item);
}
/// That says which volume it is, not where: a k-DOP's k, the dimension of a hull.
[[nodiscard]] constexpr std::size_t bytes_of_field(int) { return 0; }

/// The bytes of the numbers that say what the volume is; in float, a sphere in space has 16. Of those that are the same
/// for all of a kind, as a k-DOP's axes are, none. Of a hull its vertices, their places in the point set, and facets.
template <class VolumeType>
[[nodiscard]] std::size_t bytes_of(const VolumeType& volume) {
  if constexpr (!Listed<VolumeType>) return sizeof(VolumeType);
  std::size_t bytes = 0;
  if constexpr (Listed<VolumeType>)
    see_fields(volume, [&](std::string_view, const auto& field) { bytes += bytes_of_field(field); });
  return bytes;
}

/// Two bounds a slab: all k of them, however many the working form has room for.
template <class Scalar, int Dim>
[[nodiscard]] std::size_t bytes_of(const Kdop<Scalar, Dim>& kdop) {
  return static_cast<std::size_t>(kdop.k) * sizeof(Scalar);
}

}  // namespace snug
