#include "physics/shape.hpp"

namespace snug::physics {

V3 inertia_of(const Shape& shape) {
  if (shape.kind == Shape::Kind::kSphere) return V3::Constant(0.4 * shape.radius * shape.radius);
  const V3 squares = shape.half_extents.cwiseProduct(shape.half_extents) / 3;
  return {squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]};
}

}  // namespace snug::physics
