#include "sat.hpp"

#include <Eigen/Geometry>
#include <cmath>

using Vector3 = snug::Vector<double, 3>;
using Box = snug::Obb<double, 3>;

static double radius(const Box& box, const Vector3& axis) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += box.half_extents[i] * std::abs(box.axes.col(i).dot(axis));
  return sum;
}

static bool separates(const Box& a, const Box& b, const Vector3& axis) {
  return std::abs((b.center - a.center).dot(axis)) > radius(a, axis) + radius(b, axis);
}

bool overlap(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i)
    if (separates(a, b, a.axes.col(i)) || separates(a, b, b.axes.col(i))) return false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vector3 axis = a.axes.col(i).cross(b.axes.col(j));
      if (axis.squaredNorm() > 1e-20 && separates(a, b, axis)) return false;
    }
  return true;
}
