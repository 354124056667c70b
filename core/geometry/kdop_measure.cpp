#include "geometry/kdop_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/plane.hpp"
#include "number/double_double.hpp"
#include "number/power_of_two.hpp"

namespace snug {
namespace {

template <int Dim>
using Polygon = std::vector<Vector<double, Dim>>;

/// The k half-spaces, in double, relative to the middle of the first Dim slabs, so that a far k-DOP loses no digits.
template <class Scalar, int Dim>
std::vector<Plane<double, Dim>> half_spaces(const Kdop<Scalar, Dim>& kdop) {
  Vector<double, Dim> middle;
  for (std::size_t i = 0; i < Dim; ++i)
    middle[static_cast<int>(i)] = static_cast<double>(kdop.min[i]) / 2 + static_cast<double>(kdop.max[i]) / 2;
  std::vector<Plane<double, Dim>> planes;
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Plane<double, Dim> plane;
    DoubleDouble moved;
    for (std::size_t j = 0; j < Dim; ++j) {
      plane.normal[static_cast<int>(j)] = axes[i][j];
      moved += axes[i][j] * middle[static_cast<int>(j)];
    }
    plane.d = (moved - DoubleDouble(static_cast<double>(kdop.max[i]))).value();
    planes.push_back(plane);
    plane.normal = -plane.normal;
    plane.d = (DoubleDouble(static_cast<double>(kdop.min[i])) - moved).value();
    planes.push_back(plane);
  }
  return planes;
}

/// The part of a convex polygon that lies in the half-space.
template <int Dim>
Polygon<Dim> clipped(const Polygon<Dim>& polygon, const Plane<double, Dim>& plane) {
  Polygon<Dim> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<double, Dim>& a = polygon[i];
    const Vector<double, Dim>& b = polygon[(i + 1) % polygon.size()];
    const double at_a = signed_distance(plane, a), at_b = signed_distance(plane, b);
    if (at_a <= 0) inside.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) inside.push_back(a + (at_a / (at_a - at_b)) * (b - a));
  }
  return inside;
}

double area(const Polygon<2>& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector<double, 2> u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    twice += u[0] * v[1] - u[1] * v[0];
  }
  return std::abs(twice) / 2;
}

/// The area of a polygon times the length of its normal.
double area_along(const Vector<double, 3>& normal, const Polygon<3>& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += normal.dot((polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]));
  return std::abs(twice) / 2;
}

/// A square of the plane around its point nearest to the origin.
Polygon<3> square_on(const Plane<double, 3>& plane, double half_width) {
  int least = 0;
  plane.normal.cwiseAbs().minCoeff(&least);
  const Vector<double, 3> u = half_width * plane.normal.cross(Vector<double, 3>::Unit(least)).normalized();
  const Vector<double, 3> v = plane.normal.cross(u) / plane.normal.norm();
  const Vector<double, 3> center = plane.normal * (-plane.d / plane.normal.squaredNorm());
  return {center - u - v, center + u - v, center + u + v, center - u + v};
}

double measure_of(const std::vector<Plane<double, 2>>& planes) {
  const double x = -planes[0].d, y = -planes[2].d;  // half widths: the middle is the origin
  if (x < 0 || y < 0) return 0;
  Polygon<2> polygon{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  for (std::size_t i = 4; i < planes.size(); ++i) polygon = clipped(polygon, planes[i]);
  return area(polygon);
}

double measure_of(const std::vector<Plane<double, 3>>& planes) {
  double reach = 0;  // how far the vertices of the first three slabs' box reach, and a little more
  for (std::size_t i = 0; i < 6; ++i) reach += std::abs(planes[i].d);
  double volume = 0;
  for (std::size_t face = 0; face < planes.size(); ++face) {
    Polygon<3> polygon = square_on(planes[face], reach);
    for (std::size_t i = 0; i < planes.size() && !polygon.empty(); ++i)
      if (i != face) polygon = clipped(polygon, planes[i]);
    const Vector<double, 3>& normal = planes[face].normal;
    volume += -planes[face].d * area_along(normal, polygon) / (3 * normal.squaredNorm());
  }
  return std::max(volume, 0.0);
}

}  // namespace

/// Measured at unit size, where no square or cube over- or underflows.
template <class Scalar, int Dim>
double measure(const Kdop<Scalar, Dim>& kdop) {
  std::vector<Plane<double, Dim>> planes = half_spaces(kdop);
  double size = 0;
  for (int i = 0; i < 2 * Dim; ++i) size = std::max(size, std::abs(planes[i].d));
  if (size == 0) return 0;
  const int exponent = exponent_of(size);
  for (auto& plane : planes) plane.d = std::ldexp(plane.d, -exponent);
  return std::ldexp(measure_of(planes), Dim * exponent);
}

template double measure(const Kdop<float, 2>&);
template double measure(const Kdop<float, 3>&);
template double measure(const Kdop<double, 2>&);
template double measure(const Kdop<double, 3>&);

}  // namespace snug
