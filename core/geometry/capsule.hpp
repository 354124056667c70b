// The capsule: a sphere swept along a segment.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

#include "geometry/vector.hpp"

namespace snug {

/// All p no farther than radius from the segment from a to b, which may be the same point.
template <class Scalar, int Dim>
struct Capsule {
  Vector<Scalar, Dim> a = Vector<Scalar, Dim>::Zero();
  Vector<Scalar, Dim> b = Vector<Scalar, Dim>::Zero();
  Scalar radius = 0;  // >= 0
  static constexpr std::array<std::string_view, 3> kFields{"a", "b", "radius"};
  static auto tie(auto& own) { return std::tie(own.a, own.b, own.radius); }
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Capsule<Scalar, Dim>& capsule) {
  const double length = (capsule.b.template cast<double>() - capsule.a.template cast<double>()).norm();
  const auto r = static_cast<double>(capsule.radius);
  return Dim == 2 ? r * (std::numbers::pi * r + 2 * length) : std::numbers::pi * r * r * (4.0 / 3.0 * r + length);
}

}  // namespace snug
