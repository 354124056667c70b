#include "sat.hpp"

bool overlap(const snug::Obb<double, 3>& a, const snug::Obb<double, 3>& b) {
  // The boxes are apart if |(b.center - a.center) . axis| > r_A + r_B along one of fifteen axes: the three of A, the
  // three of B, and the nine cross products. u.dot(v) and u.cross(v) need #include <Eigen/Geometry>.
  const auto axis = a.axes.col(0);
  const double distance = (b.center - a.center).dot(axis);
  return distance <= a.half_extents[0] + b.half_extents.sum();
}
