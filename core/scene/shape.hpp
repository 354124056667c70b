// Converts the declared shape of a body into the one that the scene uses, and tests two such shapes exactly.
#pragma once

#include <variant>

#include "geometry/pose.hpp"
#include "physics/shape.hpp"
#include "scene/declaration.hpp"

namespace snug::scene {

using physics::Shape;

/// A shape about its centre, with that centre in the declared frame, and the rotation from the declared frame's axes to
/// the shape's. A box is centred, and along its own axes.
struct Centered {
  Shape shape;
  V3 center = V3::Zero();
  Matrix<double, 3> axes = Matrix<double, 3>::Identity();
};
[[nodiscard]] Centered centered(const std::variant<Volume3, Cloud>& declared);

/// Whether two placed shapes share a point, by query/overlap/overlaps.hpp.
[[nodiscard]] bool touch(const Shape& a, const Pose<double, 3>& at_a, const Shape& b, const Pose<double, 3>& at_b);

}  // namespace snug::scene
