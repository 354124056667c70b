// The sphere through a few points by the textbook's formulas, in the points' own scalar.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "fit/fit.hpp"
#include "geometry/point_set.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

namespace textbook {

template <class Scalar>
Vector<Scalar, 2> across(const Vector<Scalar, 2>& v) {
  return {-v[1], v[0]};
}

/// From the first of dim + 1 points to their circumcentre, by Cramer's rule; not finite where the determinant is 0.
template <class Scalar>
Vector<Scalar, 2> to_circumcenter(const Vector<Scalar, 2>& a, const Vector<Scalar, 2>& b) {
  const Scalar determinant = 2 * (a[0] * b[1] - a[1] * b[0]);
  return (a.squaredNorm() * -across(b) + b.squaredNorm() * across(a)) / determinant;
}
template <class Scalar>
Vector<Scalar, 3> to_circumcenter(const Vector<Scalar, 3>& a, const Vector<Scalar, 3>& b, const Vector<Scalar, 3>& c) {
  const Vector<Scalar, 3> bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
  return (a.squaredNorm() * bc + b.squaredNorm() * ca + c.squaredNorm() * ab) / (2 * a.dot(bc));
}
/// The same of three points in space.
template <class Scalar>
Vector<Scalar, 3> to_circumcenter(const Vector<Scalar, 3>& a, const Vector<Scalar, 3>& b) {
  const Vector<Scalar, 3> normal = a.cross(b);
  return (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) / (2 * normal.squaredNorm());
}

}  // namespace textbook

/// The sphere through the support, with every operation rounded to Scalar. support: 1 to Dim + 1 points. None if its
/// numbers are not finite. Source: C. Ericson, "Real-Time Collision Detection", 2005, 4.3.5.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<Sphere<Scalar, Dim>> rounded_circumsphere(PointSpan<Scalar, Dim> points,
                                                                      const Support& support) {
  const Vector<Scalar, Dim> base = points[support[0]];
  const auto edge = [&](int i) -> Vector<Scalar, Dim> { return points[support[i]] - base; };
  Vector<Scalar, Dim> to_center = Vector<Scalar, Dim>::Zero();
  if (support.size() == 2) to_center = edge(1) / 2;
  if (support.size() == 3) to_center = textbook::to_circumcenter<Scalar>(edge(1), edge(2));
  if constexpr (Dim == 3)
    if (support.size() == 4) to_center = textbook::to_circumcenter<Scalar>(edge(1), edge(2), edge(3));
  const Sphere<Scalar, Dim> sphere{base + to_center, std::sqrt(to_center.squaredNorm())};
  if (!sphere.center.allFinite() || !std::isfinite(sphere.radius)) return std::nullopt;
  return sphere;
}

}  // namespace snug::fit
