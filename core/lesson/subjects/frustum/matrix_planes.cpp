#include "lesson/subjects/frustum/matrix_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/convert.hpp"
#include "lesson/names.hpp"

namespace snug::lesson {
namespace {

/// A plane that nothing lies outside of takes the place of one without a normal.
constexpr double kRejectsNothing = 1e12;  // times the far distance

template <class Scalar>
using Matrix4 = Eigen::Matrix<Scalar, 4, 4>;

/// As gluPerspective and gluLookAt print them, in Scalar throughout.
template <class Scalar>
Matrix4<Scalar> view_projection(const FrustumCamera<double, 3>& camera) {
  const auto near = static_cast<Scalar>(camera.near), far = static_cast<Scalar>(camera.far);
  const Matrix<Scalar, 3> axes = camera.axes.cast<Scalar>();
  const Vector<Scalar, 3> position = camera.position.cast<Scalar>();
  Matrix4<Scalar> view = Matrix4<Scalar>::Identity(), projection = Matrix4<Scalar>::Zero();
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis) view(row, axis) = axes(axis, row);
    view(row, 3) = -(axes(0, row) * position[0] + axes(1, row) * position[1] + axes(2, row) * position[2]);
  }
  for (int axis = 0; axis < 2; ++axis) projection(axis, axis) = 1 / static_cast<Scalar>(camera.half_tangents[axis]);
  projection(2, 2) = (far + near) / (near - far);
  projection(2, 3) = 2 * far * near / (near - far);
  projection(3, 2) = -1;
  Matrix4<Scalar> product;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      Scalar sum = 0;  // in order, so that every build rounds alike
      for (int k = 0; k < 4; ++k) sum += projection(row, k) * view(k, column);
      product(row, column) = sum;
    }
  return product;
}

template <class Scalar>
Vector<double, 3> normal_in_double(const snug::Plane<Scalar, 3>& plane) {
  return plane.normal.template cast<double>();
}

template <class Scalar>
FarPlane far_of(const BoxPair& pair) {
  const FrustumCamera<double, 3> camera = camera_of(pair);
  const snug::Plane<Scalar, 3> plane = matrix_frustum<Scalar>(pair)[5];
  const Vector<double, 3> normal = normal_in_double(plane), view = -camera.axes.col(2);
  const auto d = static_cast<double>(plane.d);
  // How far along a direction from the camera the plane is met.
  const auto met = [&](const Vector<double, 3>& way) { return -(normal.dot(camera.position) + d) / normal.dot(way); };
  FarPlane found;
  const double at = met(view);
  found.lost = at > camera.far * (kRejectsNothing / 2);
  if (found.lost) return found;
  found.off = 100 * (at / camera.far - 1);
  found.degrees = std::acos(std::clamp(normal.normalized().dot(view), -1.0, 1.0)) * 180 / std::numbers::pi;
  for (const int bits : {0b001, 0b011, 0b111, 0b101}) {  // the far face's, in order around it
    const Vector<double, 3> way = corner_of(pair, 1, bits) - camera.position;
    const double share = met(way);
    constexpr double kMost = 4;  // beyond it the picture would be of nothing else
    if (!(share > 0 && share < kMost)) return found.corners.clear(), found;
    found.corners.push_back(camera.position + share * way);
  }
  return found;
}

}  // namespace

template <class Scalar>
Frustum<Scalar, 3> matrix_frustum(const BoxPair& pair) {
  const FrustumCamera<double, 3> camera = camera_of(pair);
  const Matrix4<Scalar> product = view_projection<Scalar>(camera);
  typename Frustum<Scalar, 3>::Planes planes;
  for (int row = 0; row < 3; ++row)
    for (int side = 0; side < 2; ++side) {
      snug::Plane<Scalar, 3>& plane = planes[2 * row + side];
      const auto entry = [&](int column) {
        const Scalar x = product(row, column), w = product(3, column);
        return side == 0 ? -(w + x) : x - w;
      };
      plane = {{entry(0), entry(1), entry(2)}, entry(3)};
    }
  auto frustum = Frustum<Scalar, 3>::make(planes);
  if (frustum) return *frustum;
  const Vector<double, 3> view = -camera.axes.col(2);
  planes[5] = {view.cast<Scalar>(), static_cast<Scalar>(-camera.far * kRejectsNothing - view.dot(camera.position))};
  frustum = Frustum<Scalar, 3>::make(planes);
  return frustum ? *frustum : Frustum<Scalar, 3>();
}
template Frustum<float, 3> matrix_frustum(const BoxPair&);
template Frustum<double, 3> matrix_frustum(const BoxPair&);

FarPlane far_plane_of(std::string_view test, const BoxPair& pair) {
  return test == kMatrixTests[0] ? far_of<double>(pair) : far_of<float>(pair);
}

bool is_of_matrix(std::string_view test) { return is_among(kMatrixTests, test); }

}  // namespace snug::lesson
