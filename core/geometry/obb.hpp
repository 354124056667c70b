// The oriented bounding box, in its working form.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "geometry/vector.hpp"

namespace snug {

/// All p with |(p - center) . axis_i| <= half_extents_i: three slabs (in 2-D two), which is how it is judged exactly.
template <class Scalar, int Dim>
struct Obb {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  Matrix<Scalar, Dim> axes = Matrix<Scalar, Dim>::Identity();      // one a column: unit, perpendicular, right-handed
  Vector<Scalar, Dim> half_extents = Vector<Scalar, Dim>::Zero();  // >= 0, scene units
  static constexpr std::array<std::string_view, 3> kFields{"center", "axes", "half_extents"};
  static auto tie(auto& own) { return std::tie(own.center, own.axes, own.half_extents); }
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Obb<Scalar, Dim>& box) {
  return (2 * box.half_extents.template cast<double>()).prod();
}

}  // namespace snug
