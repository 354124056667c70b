// A body's pose: rotated about its own origin, then moved. And the quaternion, a form in which rotations stay
// rotations.
#pragma once

#include "geometry/vector.hpp"

namespace snug {

/// A rotation of space: (x, y, z) = sin(angle / 2) times the unit axis, w = cos(angle / 2). Unit length.
/// Source: K. Shoemake, "Animating rotation with quaternion curves", 1985.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;

  /// First b, then a. Not normalized.
  friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
};

/// The quaternion at unit length within 2u, whatever its length was; no rotation if its length was 0. q: finite.
[[nodiscard]] Quaternion normalized(const Quaternion& q) noexcept;

/// Counter-clockwise as seen from the axis's tip. axis: any length, finite; the zero vector gives no rotation.
[[nodiscard]] Quaternion quaternion_about(const Vector<double, 3>& axis, double radians) noexcept;

/// Its columns are the images of the coordinate axes. q: of unit length within rounding.
[[nodiscard]] Matrix<double, 3> matrix_of(const Quaternion& q) noexcept;

/// The nearest directions that are unit and perpendicular, column by column from the first: Gram-Schmidt, twice, which
/// leaves an error of a few u. m: within 0.1 or so of a rotation.
/// Source: L. Giraud, J. Langou, M. Rozloznik, "On the round-off error analysis of the Gram-Schmidt algorithm with
/// reorthogonalization", 2002.
template <class Scalar, int Dim>
[[nodiscard]] Matrix<Scalar, Dim> orthonormal(Matrix<Scalar, Dim> m) {
  for (int i = 0; i < Dim; ++i) {
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j < i; ++j) m.col(i) -= m.col(j).dot(m.col(i)) * m.col(j);
    m.col(i) /= m.col(i).norm();
  }
  return m;
}

/// Maps a body from its local frame, about whose origin it rotates, to the world.
template <class Scalar, int Dim>
struct Pose {
  Matrix<Scalar, Dim> rotation = Matrix<Scalar, Dim>::Identity();  // within tolerance::kRotation, as from turn
  Vector<Scalar, Dim> translation = Vector<Scalar, Dim>::Zero();
};

/// Coordinate i of rotation * p, summed from the first column to the last, each operation rounded. The error bounds of
/// updates (fit/update_*.hpp) assume this order.
template <class Scalar, int Dim>
[[nodiscard]] Scalar turned_coordinate(const Matrix<Scalar, Dim>& rotation, int i, const Vector<Scalar, Dim>& p) {
  Scalar sum = rotation(i, 0) * p[0];
  for (int j = 1; j < Dim; ++j) sum += rotation(i, j) * p[j];
  return sum;
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> turned(const Matrix<Scalar, Dim>& rotation, const Vector<Scalar, Dim>& p) {
  Vector<Scalar, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = turned_coordinate<Scalar, Dim>(rotation, i, p);
  return result;
}

/// The same with the rotation's transpose, which is its inverse.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> turned_back(const Matrix<Scalar, Dim>& rotation, const Vector<Scalar, Dim>& p) {
  Vector<Scalar, Dim> result;
  for (int i = 0; i < Dim; ++i) {
    result[i] = rotation(0, i) * p[0];
    for (int j = 1; j < Dim; ++j) result[i] += rotation(j, i) * p[j];
  }
  return result;
}

/// The point's place in this pose: rotated, then moved, rounded as written.
template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> placed(const Pose<Scalar, Dim>& pose, const Vector<Scalar, Dim>& p) {
  return turned<Scalar, Dim>(pose.rotation, p) + pose.translation;
}

}  // namespace snug
