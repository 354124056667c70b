// How much memory each volume takes.
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
/// A number that belongs to a volume's type, not to its place and size, and is not counted: a k-DOP's k, a hull's
/// dimension.
[[nodiscard]] constexpr std::size_t bytes_of_field(int) { return 0; }

/// The bytes of the numbers that define the volume: a sphere in space has 16 in float. Numbers that all volumes of a
/// kind share, such as a k-DOP's axes, are not counted. A hull has its vertices, their indices in the point set, and
/// its facets.
template <class VolumeType>
[[nodiscard]] std::size_t bytes_of(const VolumeType& volume) {
  if constexpr (!Listed<VolumeType>) return sizeof(VolumeType);
  std::size_t bytes = 0;
  if constexpr (Listed<VolumeType>)
    see_fields(volume, [&](std::string_view, const auto& field) { bytes += bytes_of_field(field); });
  return bytes;
}

/// Two bounds per slab, k in all, although the working form has room for more.
template <class Scalar, int Dim>
[[nodiscard]] std::size_t bytes_of(const Kdop<Scalar, Dim>& kdop) {
  return static_cast<std::size_t>(kdop.k) * sizeof(Scalar);
}

}  // namespace snug
