// A box's axes, from one or two directions.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/tolerance.hpp"
#include "geometry/vector.hpp"
#include "number/power_of_two.hpp"

namespace snug::fit {

/// The same axes, right-handed: the last is reversed if they are not.
template <class Scalar, int Dim>
[[nodiscard]] Matrix<Scalar, Dim> right_handed(Matrix<Scalar, Dim> axes) {
  if (axes.determinant() < 0) axes.col(Dim - 1) *= -1;
  return axes;
}

/// The vector scaled to unit length (0 stays 0), without intermediate overflow or underflow.
template <int Dim>
[[nodiscard]] Vector<double, Dim> unit(const Vector<double, Dim>& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (largest == 0) return v;
  const Vector<double, Dim> scaled = v * to_unit_size(largest);
  return scaled / scaled.norm();
}

/// The coordinate axis that is farthest from a direction.
template <int Dim>
[[nodiscard]] Vector<double, Dim> axis_across(const Vector<double, Dim>& direction) {
  int least = 0;
  direction.cwiseAbs().minCoeff(&least);
  return Vector<double, Dim>::Unit(least);
}

/// Right-handed unit axes, perpendicular within a few roundings: the first along `first` and, in 3-D, the second as
/// near to `second` as a perpendicular to the first can be. Both may have any length; if one is 0, or second is
/// parallel to first, a coordinate axis takes its place.
[[nodiscard]] inline Matrix<double, 2> frame(const Vector<double, 2>& first) {
  const Vector<double, 2> x = first.isZero(0) ? Vector<double, 2>(1, 0) : unit<2>(first);
  Matrix<double, 2> axes;
  axes << x[0], -x[1], x[1], x[0];
  return axes;
}

[[nodiscard]] inline Matrix<double, 3> frame(const Vector<double, 3>& first, const Vector<double, 3>& second) {
  const Vector<double, 3> x = first.isZero(0) ? Vector<double, 3>(1, 0, 0) : unit<3>(first);
  // If second is nearly parallel, cancellation magnifies rounding errors; projecting twice removes them.
  const auto across = [&](const Vector<double, 3>& v) {
    const Vector<double, 3> once = unit<3>(v - x.dot(v) * x);
    return unit<3>(once - x.dot(once) * x);
  };
  const Vector<double, 3> along = unit<3>(second);
  const bool parallel = (along - x.dot(along) * x).norm() <= tolerance::kParallel;
  const Vector<double, 3> y = across(parallel ? axis_across<3>(x) : along);
  Matrix<double, 3> axes;
  axes << x, y, x.cross(y);
  return axes;
}

}  // namespace snug::fit
