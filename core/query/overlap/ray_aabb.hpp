// Where a ray enters an axis-aligned box, slab by slab.
// Source: T. L. Kay, J. T. Kajiya, "Ray tracing complex scenes", 1986; T. Ize, "Robust BVH ray traversal", 2013, for
// moving the exit out by the rounding error.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/aabb.hpp"
#include "geometry/ray.hpp"
#include "geometry/tolerance.hpp"

namespace snug::query {

/// The t at which the ray enters the box, within kRaySlab of t; 0 if it begins inside, none if it misses. It never
/// misses a box that the ray touches, and may report a hit on a box that the ray passes within kRaySlab of t. If one
/// box contains another, a ray that hits the inner one hits the outer one, and no later, because rounding never changes
/// an order. Coordinates and their differences must be finite; t is infinite if it overflows.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<Scalar> ray_enters(const Aabb<Scalar, Dim>& box, const Ray<Scalar, Dim>& ray) {
  Scalar enter = 0, leave = std::numeric_limits<Scalar>::infinity();
  for (int i = 0; i < Dim; ++i) {
    const Scalar o = ray.origin[i], d = ray.direction[i];
    if (d == 0) {
      if (o < box.min[i] || o > box.max[i]) return std::nullopt;
      continue;
    }
    const Scalar near = ((d > 0 ? box.min[i] : box.max[i]) - o) / d, far = ((d > 0 ? box.max[i] : box.min[i]) - o) / d;
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  // A box behind the ray stays behind, because rounding does not change the sign of a difference.
  if (leave < 0) return std::nullopt;
  const Scalar open = leave + (tolerance::kRaySlab<Scalar> * leave + 4 * std::numeric_limits<Scalar>::denorm_min());
  if (enter > open) return std::nullopt;
  return enter;
}

}  // namespace snug::query
