// A box in any kind of number, rounded or exact: the tests by separating axes ask it how far it reaches along an axis.
#pragma once

#include <array>

#include "geometry/aabb.hpp"
#include "geometry/obb.hpp"
#include "geometry/reach.hpp"
#include "number/tuple.hpp"

namespace snug::query {

/// All center + sum s_i half_i axes_i with |s_i| <= 1.
template <class Number, std::size_t Dim>
struct BoxOf {
  Tuple<Number, Dim> center, half;
  std::array<Tuple<Number, Dim>, Dim> axes;

  template <class Scalar>
  explicit BoxOf(const Obb<Scalar, Dim>& box)
      : center(tuple_of<Number, Dim>(box.center)), half(tuple_of<Number, Dim>(box.half_extents)) {
    for (std::size_t k = 0; k < Dim; ++k) axes[k] = tuple_of<Number, Dim>(box.axes.col(static_cast<int>(k)));
  }
  template <class Scalar>
  explicit BoxOf(const Aabb<Scalar, Dim>& box) {
    const auto min = tuple_of<Number, Dim>(box.min), max = tuple_of<Number, Dim>(box.max);
    for (std::size_t k = 0; k < Dim; ++k) {
      center[k] = (min[k] + max[k]) * Number(0.5);
      half[k] = (max[k] - min[k]) * Number(0.5);
      for (std::size_t i = 0; i < Dim; ++i) axes[k][i] = Number(i == k ? 1.0 : 0.0);
    }
  }

  /// Half of its projection onto the axis, times the axis's length.
  [[nodiscard]] Number radius(const Tuple<Number, Dim>& axis) const {
    Number sum = half[0] * magnitude(dot(axes[0], axis));
    for (std::size_t k = 1; k < Dim; ++k) sum += half[k] * magnitude(dot(axes[k], axis));
    return sum;
  }
  [[nodiscard]] Span<Number> along(const Tuple<Number, Dim>& axis) const {
    const Number middle = dot(center, axis), own = radius(axis);
    return {middle - own, middle + own};
  }
  /// The cross product of the face's edges, even where the axes are not exactly perpendicular.
  [[nodiscard]] Tuple<Number, Dim> normal(std::size_t face) const {
    if constexpr (Dim == 2) return {Number(0.0) - axes[1 - face][1], axes[1 - face][0]};
    else return cross(axes[(face + 1) % 3], axes[(face + 2) % 3]);
  }
};

}  // namespace snug::query
