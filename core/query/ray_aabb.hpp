// Where a ray enters an axis-aligned box, slab by slab.
// Source: T. L. Kay, J. T. Kajiya, "Ray tracing complex scenes", 1986; T. Ize, "Robust BVH ray traversal", 2013, for
// the last slab that the ray leaves being held open a little.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/aabb.hpp"
#include "geometry/ray.hpp"
#include "geometry/tolerance.hpp"

namespace snug::query {

/// The t at which the ray is first in the box, 0 where it begins there, within kRaySlab of t; none where it misses. It
/// never misses a box that the ray touches, and takes for a hit what passes it by no more than kRaySlab of t. Of two
/// boxes, one in the other, whatever hits the inner one hits the outer, and no later: rounding never changes an order.
/// Coordinates finite, their differences too; t may be infinite where it is more than any Scalar.
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
    enter = std::max(enter, near), leave = std::min(leave, far);
  }
  // A box behind the ray stays behind, for a difference has its sign whatever is rounded.
  if (leave < 0) return std::nullopt;
  const Scalar open = leave + (tolerance::kRaySlab<Scalar> * leave + 4 * std::numeric_limits<Scalar>::denorm_min());
  if (enter > open) return std::nullopt;
  return enter;
}

}  // namespace snug::query
