// A rigid body's shape: the convex hull of corners grown by a radius. Spheres and boxes are marked as such.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/point_set.hpp"
#include "geometry/vector.hpp"

namespace snug::physics {

using V3 = Vector<double, 3>;

struct Shape {
  enum class Kind : std::uint8_t { kSphere, kBox, kOther } kind = Kind::kSphere;
  V3 half_extents = V3::Zero();              // of a box
  double radius = 0;                         // around the corners; of a sphere its own
  std::vector<V3> corners;                   // about the body's centre
  double reach = 0;                          // no point of the shape is farther from the centre
  double thinnest = 0;                       // half of its least thickness, or less
  std::shared_ptr<const AnyPointSet> cloud;  // where it was declared as points
};

/// The inertia of one kilogram about the shape's axes; for a shape that is neither sphere nor box, that of the box
/// around it.
[[nodiscard]] V3 inertia_of(const Shape& shape);

}  // namespace snug::physics
