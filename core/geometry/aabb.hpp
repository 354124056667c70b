// The axis-aligned bounding box, in its working form.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "geometry/vector.hpp"

namespace snug {

/// All p with min <= p <= max in every coordinate, scene units.
template <class Scalar, int Dim>
struct Aabb {
  Vector<Scalar, Dim> min = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> max = Vector<Scalar, Dim>::Zero();  // >= min
  static constexpr std::array<std::string_view, 2> kFields{"min", "max"};
  static auto tie(auto& own) { return std::tie(own.min, own.max); }
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Aabb<Scalar, Dim>& box) {
  return (box.max.template cast<double>() - box.min.template cast<double>()).prod();
}

}  // namespace snug
