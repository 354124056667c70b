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
/// 1e-7 of these, for a distance that is right to its last digits leaves them so much room.
template <int Dim>
struct SignedDistance {
  double distance = 0;
  /// Unit, from a to b. Of volumes apart: along it lies the gap. Of others: b, moved by the depth along it, touches a.
  Vector<double, Dim> direction = Vector<double, Dim>::Zero();
  /// Points of a and of b: the nearest, or the ends of the depth, which that move brings together.
  Vector<double, Dim> on_a = Vector<double, Dim>::Zero();
  Vector<double, Dim> on_b = Vector<double, Dim>::Zero();
};

/// None if one is empty. GJK where the cores are apart, which leaves the radii to subtract; else the polytope within
/// the cores' difference grows, where it is nearest to the origin, until a facet of it is one of the difference.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<SignedDistance<Dim>> signed_distance(const Volume<Scalar, Dim>& a,
                                                                 const Volume<Scalar, Dim>& b);

/// Between what the signed distance of two cores lies, which are at most 1 in every coordinate (query::scale_to_unit):
/// a plane proves the lower bound and points of both the upper one, but for a few roundings. In the plane z = 0.
struct DistanceBounds {
  double least = 0, most = 0;
};
template <int Dim>
[[nodiscard]] DistanceBounds bounds_between(const query::GrownCore& a, const query::GrownCore& b);

}  // namespace snug::proximity
