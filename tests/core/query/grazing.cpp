#include "core/query/grazing.hpp"

namespace snug::test {
namespace {

template <class Scalar, int Dim>
Frustum<Scalar, Dim> with_any_lengths(const Frustum<Scalar, Dim>& frustum, Random& random) {
  auto planes = frustum.planes();
  for (auto& plane : planes) {
    const Scalar mantissa = static_cast<Scalar>(random.between(1, 3));
    const Scalar length = std::ldexp(mantissa, static_cast<int>(random.below(21)) - 10);
    plane.normal *= length;
    plane.d *= length;
  }
  return *Frustum<Scalar, Dim>::make(planes);
}

/// perspective times view, column by column, as OpenGL has it.
template <class Scalar>
Frustum<Scalar, 3> by_matrix(const FrustumCamera<Scalar, 3>& camera) {
  const double near = static_cast<double>(camera.near), far = static_cast<double>(camera.far);
  Eigen::Matrix4d perspective = Eigen::Matrix4d::Zero(), view = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 2; ++i) perspective(i, i) = 1 / static_cast<double>(camera.half_tangents[i]);
  perspective(2, 2) = (far + near) / (near - far);
  perspective(2, 3) = 2 * far * near / (near - far);
  perspective(3, 2) = -1;
  view.topLeftCorner<3, 3>() = camera.axes.template cast<double>().transpose();
  view.topRightCorner<3, 1>() = -view.topLeftCorner<3, 3>() * camera.position.template cast<double>();
  const Eigen::Matrix<Scalar, 4, 4> both = (perspective * view).cast<Scalar>();
  return *frustum_of_matrix<Scalar>(std::span<const Scalar>(both.data(), 16));
}

}  // namespace

template <class Scalar, int Dim>
Scene<Scalar, Dim> any_scene(int kind, Random& random) {
  FrustumCamera<Scalar, Dim> camera;
  const double size = kind == 4 ? std::ldexp(1.0, static_cast<int>(random.below(41)) - 20) : 1;
  camera.near = static_cast<Scalar>(size);
  camera.far = static_cast<Scalar>(16 * size);
  if (kind > 0) {
    const double offset = kind == 2 ? 1e5 : 4 * size;
    camera.position = any_vector<Dim>(random, offset).template cast<Scalar>();
    camera.axes = any_turn<Dim>(random).template cast<Scalar>();
    for (int i = 0; i < Dim - 1; ++i) camera.half_tangents[i] = static_cast<Scalar>(random.between(0.3, 1.5));
    camera.near = static_cast<Scalar>(size * random.between(0.3, 2));
  }
  Frustum<Scalar, Dim> frustum = *frustum_of_camera(camera);
  if (kind == 3) frustum = with_any_lengths(frustum, random);
  if constexpr (Dim == 3)
    if (kind == 5) frustum = by_matrix(camera);
  const Vector<double, Dim> back = camera.axes.col(Dim - 1).template cast<double>();
  return {frustum, camera.position.template cast<double>() - 8 * size * back, 8 * size};
}

template Scene<float, 2> any_scene(int, Random&);
template Scene<float, 3> any_scene(int, Random&);
template Scene<double, 2> any_scene(int, Random&);
template Scene<double, 3> any_scene(int, Random&);

}  // namespace snug::test
