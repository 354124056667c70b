// The lozenge: a sphere swept over a rectangle (also called a rectangle-swept sphere, RSS).
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/core.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// All p no farther than radius from the rectangle of origin + s edges[0] + t edges[1], 0 <= s, t <= 1. An edge may be
/// zero. In 2-D it is a rectangle with round corners.
template <class Scalar, int Dim>
struct Lozenge {
  Vector<Scalar, Dim> origin = Vector<Scalar, Dim>::Zero();
  std::array<Vector<Scalar, Dim>, 2> edges{Vector<Scalar, Dim>::Zero(), Vector<Scalar, Dim>::Zero()};  // perpendicular
  Scalar radius = 0;                                                                                   // >= 0
  SNUG_FIELDS(origin, edges, radius);
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

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Lozenge<Scalar, Dim>& lozenge) {
  return lozenge.origin;
}

/// The core is the rectangle.
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Lozenge<Scalar, Dim>& lozenge, const Vector<Scalar, Dim>& origin) {
  const Vector<double, Dim> corner = difference(lozenge.origin, origin);
  const Vector<double, Dim> e = lozenge.edges[0].template cast<double>();
  const Vector<double, Dim> f = lozenge.edges[1].template cast<double>();
  return {corner, corner + e, corner + f, corner + (e + f)};
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Lozenge<Scalar, Dim>& lozenge) {
  return lozenge.radius;
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Lozenge<Scalar, Dim>& lozenge) {
  Span<Number> span = core_span<Number>(plane, lozenge.origin);
  for (const auto& edge : lozenge.edges) {
    const Number step = dot_as<Number, Scalar, Dim>(plane.normal, edge);
    (step < Number(0) ? span.low : span.high) += step;
  }
  return span;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Lozenge<Scalar, Dim>& lozenge) {
  return largest<Scalar, Dim>(lozenge.origin) + largest<Scalar, Dim>(lozenge.edges[0]) +
         largest<Scalar, Dim>(lozenge.edges[1]) + lozenge.radius;
}

template <class Scalar, int Dim>
[[nodiscard]] Lozenge<Scalar, Dim> moved(const Lozenge<Scalar, Dim>& lozenge, const Vector<Scalar, Dim>& by) {
  return {lozenge.origin + by, lozenge.edges, lozenge.radius};
}
template <class Scalar, int Dim>
[[nodiscard]] Lozenge<Scalar, Dim> turned(const Lozenge<Scalar, Dim>& lozenge, const Matrix<Scalar, Dim>& rotation) {
  const Vector<Scalar, Dim> middle = lozenge.origin + (lozenge.edges[0] + lozenge.edges[1]) / 2;
  const Vector<Scalar, Dim> e = rotation * lozenge.edges[0], f = rotation * lozenge.edges[1];
  return {middle - (e + f) / 2, {e, f}, lozenge.radius};
}

}  // namespace snug
