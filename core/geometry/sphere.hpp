// The sphere (in 2-D the circle), and the exact question whether it holds a point.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/point_set.hpp"
#include "geometry/vector.hpp"

namespace snug {

template <class Scalar, int Dim>
struct Sphere {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  Scalar radius = 0;  // >= 0
};

/// -1, 0 or +1: whether a point lies inside, on or outside a sphere, in exact arithmetic on the numbers as they are.
/// point, center: dim finite coordinates, 1 <= dim <= 3. radius: finite, >= 0.
int side_of_sphere(const double* point, const double* center, double radius, int dim) noexcept;

template <class Scalar, int Dim>
[[nodiscard]] int side_of_sphere(const Vector<Scalar, Dim>& point, const Sphere<Scalar, Dim>& sphere) noexcept {
  const Vector<double, Dim> p = point.template cast<double>();
  const Vector<double, Dim> c = sphere.center.template cast<double>();
  return side_of_sphere(p.data(), c.data(), static_cast<double>(sphere.radius), Dim);
}

/// |v| without overflow or underflow on the way.
template <class Scalar, int Dim>
[[nodiscard]] Scalar scaled_norm(const Vector<Scalar, Dim>& v) {
  const Scalar largest = v.cwiseAbs().maxCoeff();
  if (largest == 0) return 0;
  const int exponent = std::ilogb(largest);
  Vector<Scalar, Dim> scaled;
  for (int i = 0; i < Dim; ++i) scaled[i] = std::ldexp(v[i], -exponent);
  return std::ldexp(std::sqrt(scaled.squaredNorm()), exponent);
}

template <class Scalar>
struct EnclosingRadius {
  Scalar radius = 0;
  Index farthest = 0;  // the point that sets it
};

/// The smallest radius, within kSquaredDistance, with which a sphere around center holds every point exactly.
/// One pass over the points and a second over those blocks of them that reach the boundary.
template <class Scalar, int Dim>
[[nodiscard]] EnclosingRadius<Scalar> enclosing_radius(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points);

extern template EnclosingRadius<float> enclosing_radius(const Vector<float, 2>&, PointSpan<float, 2>);
extern template EnclosingRadius<float> enclosing_radius(const Vector<float, 3>&, PointSpan<float, 3>);
extern template EnclosingRadius<double> enclosing_radius(const Vector<double, 2>&, PointSpan<double, 2>);
extern template EnclosingRadius<double> enclosing_radius(const Vector<double, 3>&, PointSpan<double, 3>);

/// Area (2-D) or volume (3-D), in scene units squared or cubed.
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Sphere<Scalar, Dim>& sphere) {
  const double r = static_cast<double>(sphere.radius);
  return Dim == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

}  // namespace snug
