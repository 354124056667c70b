// The lozenge: a sphere swept over a rectangle (also called a rectangle-swept sphere, RSS).
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

#include "geometry/vector.hpp"

namespace snug {

/// All p no farther than radius from the rectangle of origin + s edges[0] + t edges[1], 0 <= s, t <= 1. An edge may be
/// zero. In 2-D it is a rectangle with round corners.
template <class Scalar, int Dim>
struct Lozenge {
  Vector<Scalar, Dim> origin = Vector<Scalar, Dim>::Zero();
  std::array<Vector<Scalar, Dim>, 2> edges{Vector<Scalar, Dim>::Zero(), Vector<Scalar, Dim>::Zero()};  // perpendicular
  Scalar radius = 0;                                                                                   // >= 0
  static constexpr std::array<std::string_view, 3> kFields{"origin", "edges", "radius"};
  static auto tie(auto& own) { return std::tie(own.origin, own.edges, own.radius); }
};

/// Area (2-D) or volume (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Lozenge<Scalar, Dim>& lozenge) {
  const double x = lozenge.edges[0].template cast<double>().norm();
  const double y = lozenge.edges[1].template cast<double>().norm();
  const auto r = static_cast<double>(lozenge.radius);
  constexpr double kPi = std::numbers::pi;
  return Dim == 2 ? x * y + 2 * r * (x + y) + kPi * r * r
                  : 2 * r * x * y + kPi * r * r * (x + y) + 4.0 / 3.0 * kPi * r * r * r;
}

}  // namespace snug
