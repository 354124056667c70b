// What some functions take, read from their numbers, for those that judge it and the stage that shows it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/aabb.hpp"
#include "geometry/frustum.hpp"
#include "geometry/ray.hpp"
#include "write/function.hpp"

namespace snug::write {

// ---- a box against a frustum -------------------------------------------------------------------------------------

using Planes = Frustum<double, 3>::Planes;

struct CullInput {
  Planes planes;
  Aabb<double, 3> box;
};
[[nodiscard]] CullInput cull_input_of(const Numbers& input);

/// It sees 90 degrees both ways.
struct Camera {
  Vector<double, 3> apex = Vector<double, 3>::Zero();
  Vector<double, 3> view = Vector<double, 3>::UnitX();  // unit
  double near = 1, far = 2;
};
/// The camera whose frustum these planes are, in any order; null if they are none along an axis.
[[nodiscard]] std::optional<Camera> camera_of(const Planes& planes);

// ---- a ray through a tree ----------------------------------------------------------------------------------------

/// Indices are -1 where there is no such node.
struct Node {
  Aabb<double, 2> box;
  double parent = -1, left = -1, right = -1;
};
struct RayInput {
  std::vector<Node> nodes;
  Ray<double, 2> ray;
};
[[nodiscard]] RayInput ray_input_of(const Numbers& input);

}  // namespace snug::write
