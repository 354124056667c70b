// How far apart two volumes of any kind are, or how deep they lie in each other.
// Source: G. van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001: the
// expanding polytope; C. Ericson, Real-Time Collision Detection, 2005, 9.3.8.
#pragma once

#include <optional>

#include "geometry/volume.hpp"
#include "query/distance/gjk.hpp"

namespace snug::proximity {

/// Volumes that overlap have a negative distance: minus their depth, the length of the shortest move that parts them.
/// Scene units, within some roundings of the volumes' extents about a common point; the direction and the points within
/// 1e-7 of these, because a distance that is right to its last digits leaves them that uncertain.
template <int Dim>
struct SignedDistance {
  double distance = 0;
  /// Unit, from a to b. If the volumes are apart, the gap lies along it; otherwise b, moved along it by the depth,
  /// touches a.
  Vector<double, Dim> direction = Vector<double, Dim>::Zero();
  /// Points of a and of b: the nearest ones, or those that this move brings together.
  Vector<double, Dim> on_a = Vector<double, Dim>::Zero();
  Vector<double, Dim> on_b = Vector<double, Dim>::Zero();
};

/// None if one is empty. Where the cores are apart, GJK finds their distance, less the radii. Otherwise a polytope
/// within the cores' difference grows where it is nearest to the origin, until its nearest facet is one of the
/// difference.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<SignedDistance<Dim>> signed_distance(const Volume<Scalar, Dim>& a,
                                                                 const Volume<Scalar, Dim>& b);

/// Bounds on the signed distance of two cores, which are at most 1 in every coordinate (query::scale_to_unit) and have
/// z = 0 in the plane. Within a few roundings, a plane proves the lower bound, and a point of each core the upper one.
struct DistanceBounds {
  double least = 0, most = 0;
};
template <int Dim>
[[nodiscard]] DistanceBounds bounds_between(const query::GrownCore& a, const query::GrownCore& b);

}  // namespace snug::proximity
