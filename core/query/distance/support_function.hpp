// The points of any volume that lie farthest in a direction, from its own header alone (geometry/volume.hpp).
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "geometry/volume.hpp"

namespace snug::query {

/// A volume's scalar, dimension and place in Volume and kVolumeNames.
template <class Kind>
struct VolumeKind;
template <template <class, int> class Kind, class ScalarType, int dim>
struct VolumeKind<Kind<ScalarType, dim>> {
  using Scalar = ScalarType;
  static constexpr int kDim = dim;
  static constexpr std::size_t kIndex = [] {
    const auto place = []<class... Kinds>(const std::variant<Kinds...>*) {
      std::size_t i = 0;
      (void)((std::is_same_v<Kinds, Kind<Scalar, kDim>> || (++i, false)) || ...);
      return i;
    };
    return place(static_cast<const Volume<Scalar, kDim>*>(nullptr));
  }();
};

/// A volume whose core is the hull of corners; those of all others are smooth.
template <class Kind>
concept HasCorners = requires(const Kind& volume) {
  core_corners(volume, anchor(volume));
};

/// A volume that is its core grown by a radius.
template <class Kind>
concept HasRadius = requires(const Kind& volume) {
  core_radius(volume);
};

/// The radius around the core: 0 where a volume has none.
template <class Kind>
[[nodiscard]] auto radius_of(const Kind& volume) {
  if constexpr (HasRadius<Kind>) return core_radius(volume);
  else return typename VolumeKind<Kind>::Scalar(0);
}

/// The vertex farthest along a direction; the first of several. corners: at least one.
template <int Dim>
[[nodiscard]] std::size_t farthest_corner(const Corners<Dim>& corners, const Vector<double, Dim>& direction) {
  std::size_t farthest = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double reach = corners[i].dot(direction);
    if (reach > most) {
      most = reach;
      farthest = i;
    }
  }
  return farthest;
}

/// The core's point farthest along a direction, within rounding, relative to an origin. direction: of a size near 1.
/// The volume must not be empty.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] Vector<double, Dim> farthest_of_core(const Kind<Scalar, Dim>& volume, const Vector<Scalar, Dim>& origin,
                                                   const Vector<double, Dim>& direction) {
  if constexpr (HasCorners<Kind<Scalar, Dim>>) {
    const Corners<Dim> corners = core_corners(volume, origin);
    return corners[farthest_corner<Dim>(corners, direction)];
  } else {
    return core_support(volume, origin, direction);
  }
}

/// A point of the volume farthest along a direction, within rounding. direction: not zero, need not be unit. The volume
/// must not be empty.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> support(const Kind<Scalar, Dim>& volume,
                                          const std::type_identity_t<Vector<Scalar, Dim>>& direction) {
  const Vector<Scalar, Dim> origin = anchor(volume);
  const Vector<double, Dim> towards =
      direction.template cast<double>() / direction.template cast<double>().cwiseAbs().maxCoeff();
  const Vector<double, Dim> point =
      farthest_of_core(volume, origin, towards) + static_cast<double>(radius_of(volume)) / towards.norm() * towards;
  return (origin.template cast<double>() + point).template cast<Scalar>();
}

/// The axis-aligned box around a volume, within rounding. The volume must not be empty.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] Aabb<double, Dim> box_around(const Kind<Scalar, Dim>& volume) {
  const Vector<Scalar, Dim> origin = anchor(volume);
  const Vector<double, Dim> at = origin.template cast<double>();
  const auto radius = static_cast<double>(radius_of(volume));
  Aabb<double, Dim> box;
  for (int i = 0; i < Dim; ++i) {
    const Vector<double, Dim> axis = Vector<double, Dim>::Unit(i);
    box.min[i] = at[i] + farthest_of_core(volume, origin, Vector<double, Dim>(-axis))[i] - radius;
    box.max[i] = at[i] + farthest_of_core(volume, origin, axis)[i] + radius;
  }
  return box;
}

}  // namespace snug::query
