// A body's shape as the scene works with it: the convex hull of corners grown by a radius, of which spheres and boxes
// are known as such.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/obb.hpp"
#include "geometry/pose.hpp"
#include "geometry/sphere.hpp"
#include "scene/declaration.hpp"

namespace snug::scene {

struct Shape {
  enum class Kind : std::uint8_t { kSphere, kBox, kOther } kind = Kind::kSphere;
  V3 half_extents = V3::Zero();              // of a box
  double radius = 0;                         // around the corners; of a sphere its own
  std::vector<V3> corners;                   // about the body's centre
  double reach = 0;                          // no point of the shape is farther from the centre
  double thinnest = 0;                       // half of its least thickness, or less
  std::shared_ptr<const AnyPointSet> cloud;  // where it was declared as points
};

/// The shape about its centre: where that lies in the declared frame, and how the declared frame's axes turn into the
/// shape's. Boxes are taken about their middles, along their own axes.
struct Centered {
  Shape shape;
  V3 center = V3::Zero();
  Matrix<double, 3> axes = Matrix<double, 3>::Identity();
};
[[nodiscard]] Centered centered(const std::variant<Volume3, Cloud>& declared);

/// The inertia of one kilogram about the shape's axes; for a shape that is neither sphere nor box, that of the box
/// around it.
[[nodiscard]] V3 inertia_of(const Shape& shape);

/// Whether two placed shapes share a point, as query/overlaps.hpp has it.
[[nodiscard]] bool touch(const Shape& a, const Pose<double, 3>& at_a, const Shape& b, const Pose<double, 3>& at_b);

}  // namespace snug::scene
