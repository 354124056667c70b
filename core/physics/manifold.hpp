// Where two bodies touch, or nearly: the points at which impulses act.
#pragma once

#include <array>
#include <span>

#include "physics/shape.hpp"

namespace snug::physics {

struct ManifoldPoint {
  V3 position = V3::Zero();  // midway between the surfaces
  double separation = 0;     // scene units; negative for a penetration
};

struct Manifold {
  V3 normal = V3::Zero();  // unit, from a to b
  std::array<ManifoldPoint, 8> points;
  int count = 0;

  [[nodiscard]] std::span<const ManifoldPoint> all() const { return std::span(points).first(count); }
};

/// Empty if they are farther apart than margin. Spheres and boxes only (has_manifolds). For boxes, the separating-axis
/// test finds the axis of least overlap, and the faces there are clipped against each other.
/// Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.4.1 and 8.3.4; D. Gregorius, "The Separating Axis
/// Test", 2013.
[[nodiscard]] Manifold manifold_of(const Shape& a, const Pose<double, 3>& at_a, const Shape& b,
                                   const Pose<double, 3>& at_b, double margin);

/// manifold_of's separation: the distance or a lower bound; if the shapes share a point, minus the least way that one
/// has to move to be apart. If no point of either moves farther than a length, it changes by no more.
[[nodiscard]] double separation_of(const Shape& a, const Pose<double, 3>& at_a, const Shape& b,
                                   const Pose<double, 3>& at_b);

[[nodiscard]] inline bool has_manifolds(const Shape& shape) { return shape.kind != Shape::Kind::kOther; }

}  // namespace snug::physics
