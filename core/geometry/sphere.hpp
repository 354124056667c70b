// The sphere (in 2-D the circle), and whether it contains a point, decided exactly.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/core.hpp"
#include "geometry/point_set.hpp"
#include "geometry/reach.hpp"
#include "geometry/vector.hpp"
#include "number/power_of_two.hpp"
#include "trace/fields.hpp"

namespace snug {

template <class Scalar, int Dim>
struct Sphere {
  Vector<Scalar, Dim> center = Vector<Scalar, Dim>::Zero();
  Scalar radius = 0;  // >= 0
  SNUG_FIELDS(center, radius);
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

/// |v|, without overflow or underflow in between.
template <class Scalar, int Dim>
[[nodiscard]] Scalar scaled_norm(const Vector<Scalar, Dim>& v) {
  const Scalar largest = v.cwiseAbs().maxCoeff();
  if (largest == 0) return 0;
  const int exponent = exponent_of(largest);
  Vector<Scalar, Dim> scaled;
  for (int i = 0; i < Dim; ++i) scaled[i] = std::ldexp(v[i], -exponent);
  return std::ldexp(std::sqrt(scaled.squaredNorm()), exponent);
}

/// The farthest point from a centre, of all points and of each block of points. There are about as many blocks as
/// points in a block.
template <class Scalar>
struct FarthestPoints {
  struct Far {
    Scalar square = 0;  // the squared distance, as rounded
    Index point = 0;
  };
  Far overall;
  Index block = 0;  // points
  std::vector<Far> of_block;
};

/// One pass.
template <class Scalar, int Dim>
[[nodiscard]] FarthestPoints<Scalar> farthest_points(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points);

/// The smallest radius, within kSquaredDistance, with which a sphere around center contains every point exactly.
/// far: for the same centre and points. Looks again only at those blocks that reach the boundary.
template <class Scalar, int Dim>
[[nodiscard]] Scalar enclosing_radius(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points,
                                      const FarthestPoints<Scalar>& far);

/// Area (2-D) or volume (3-D), in scene units squared or cubed.
template <class Scalar, int Dim>
[[nodiscard]] double measure(const Sphere<Scalar, Dim>& sphere) {
  const double r = static_cast<double>(sphere.radius);
  return Dim == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor(const Sphere<Scalar, Dim>& sphere) {
  return sphere.center;
}

/// The core is the centre.
template <class Scalar, int Dim>
[[nodiscard]] Corners<Dim> core_corners(const Sphere<Scalar, Dim>& sphere, const Vector<Scalar, Dim>& origin) {
  return {difference(sphere.center, origin)};
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar core_radius(const Sphere<Scalar, Dim>& sphere) {
  return sphere.radius;
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Sphere<Scalar, Dim>& sphere) {
  return core_span<Number>(plane, sphere.center);
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Sphere<Scalar, Dim>& sphere) {
  return largest<Scalar, Dim>(sphere.center) + sphere.radius;
}

template <class Scalar, int Dim>
[[nodiscard]] bool contains(const Sphere<Scalar, Dim>& sphere, const std::type_identity_t<Vector<Scalar, Dim>>& point) {
  return side_of_sphere(point, sphere) <= 0;
}

template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> moved(const Sphere<Scalar, Dim>& sphere, const Vector<Scalar, Dim>& by) {
  return {sphere.center + by, sphere.radius};
}

}  // namespace snug
