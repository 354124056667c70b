// From the shape that a body is declared with to the one that the scene works with, and the exact test between two.
#pragma once

#include <variant>

#include "geometry/pose.hpp"
#include "physics/shape.hpp"
#include "scene/declaration.hpp"

namespace snug::scene {

using physics::Shape;

/// The shape about its centre: where that lies in the declared frame, and how the declared frame's axes turn into the
/// shape's. Boxes are taken about their middles, along their own axes.
struct Centered {
  Shape shape;
  V3 center = V3::Zero();
  Matrix<double, 3> axes = Matrix<double, 3>::Identity();
};
[[nodiscard]] Centered centered(const std::variant<Volume3, Cloud>& declared);

/// Whether two placed shapes share a point, as query/overlaps.hpp has it.
[[nodiscard]] bool touch(const Shape& a, const Pose<double, 3>& at_a, const Shape& b, const Pose<double, 3>& at_b);

}  // namespace snug::scene
