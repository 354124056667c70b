// Frusta that tests share, and volumes that touch one of their planes within a few units in the last place.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/query/box_pairs.hpp"
#include "geometry/frustum.hpp"
#include "query/cull/plane_reach.hpp"

namespace snug::test {

/// What may be hard about a frustum: nothing (whole numbers, upright), turned, far from the origin, with normals of any
/// length, in a scene much smaller or larger, of a matrix (in 2-D turned).
inline constexpr int kFrustumKinds = 6;
/// A frustum, and where it is.
template <class Scalar, int Dim>
struct Scene {
  Frustum<Scalar, Dim> frustum;
  Vector<double, Dim> middle;
  double size = 1;
};
template <class Scalar, int Dim>
Scene<Scalar, Dim> any_scene(int kind, Random& random);

/// Where the numbers are that a volume is moved by.
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(Vector<Scalar, Dim>& point, int j) {
  return {&point[j]};
}
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(Sphere<Scalar, Dim>& sphere, int j) {
  return {&sphere.center[j]};
}
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(Aabb<Scalar, Dim>& box, int j) {
  return {&box.min[j], &box.max[j]};
}
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(AabbCenterExtents<Scalar, Dim>& box, int j) {
  return {&box.center[j]};
}
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(Obb<Scalar, Dim>& box, int j) {
  return {&box.center[j]};
}
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(Capsule<Scalar, Dim>& capsule, int j) {
  return {&capsule.a[j], &capsule.b[j]};
}
template <class Scalar, int Dim>
std::vector<Scalar*> coordinates(Lozenge<Scalar, Dim>& lozenge, int j) {
  return {&lozenge.origin[j]};
}

/// Moves the volume along a coordinate until it touches a plane, from inside or outside, but for up to three steps of
/// that coordinate.
template <class Scalar, int Dim, class Shape>
void graze(const Plane<Scalar, Dim>& plane, Shape& volume, Random& random) {
  int j = static_cast<int>(random.below(Dim));
  while (plane.normal[j] == 0) j = (j + 1) % Dim;
  const bool from_outside = random.below(2) == 0;
  for (int pass = 0; pass < 2; ++pass) {
    const auto span = query::span_of(plane, volume);
    const Scalar by = (from_outside ? span.low : span.high) / plane.normal[j];
    for (Scalar* at : coordinates<Scalar, Dim>(volume, j)) *at -= by;
  }
  const auto steps = static_cast<int>(random.below(7)) - 3;
  for (int step = 0; step < std::abs(steps); ++step)
    for (Scalar* at : coordinates<Scalar, Dim>(volume, j))
      *at = std::nextafter(*at, std::numeric_limits<Scalar>::infinity() * static_cast<Scalar>(steps));
}

}  // namespace snug::test
