#include "geometry/frustum.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "geometry/sphere.hpp"
#include "number/dyadic.hpp"

namespace snug {
namespace {

template <class Scalar, int Dim>
std::string plane_said(std::size_t plane) {
  return "plane " + std::to_string(plane) + " (" + std::string(kFrustumPlaneNames<Dim>[plane]) + ")";
}

template <class Scalar, int Dim>
std::optional<std::string> wrong_with(const Plane<Scalar, Dim>& plane) {
  constexpr Scalar kLargest = Frustum<Scalar, Dim>::kLargest;
  if (!plane.normal.allFinite() || !std::isfinite(plane.d)) return "is not finite";
  const Scalar largest = plane.normal.cwiseAbs().maxCoeff();
  if (largest == 0) return "has no normal: it is zero";
  if (largest > kLargest) return "has a normal longer than this program can take";
  if (largest < 1 / kLargest) return "has a normal shorter than this program can take";
  if (std::abs(plane.d) > 4 * kLargest * largest) return "is farther away than this program can take";
  return std::nullopt;
}

/// Whether the determinant is exactly zero, from the minors of the first two rows and those of the last two.
template <class Scalar>
bool is_singular(std::span<const Scalar> column_major) {
  const auto at = [&](std::size_t row, std::size_t column) {
    return Dyadic(static_cast<double>(column_major[4 * column + row]));
  };
  const auto minor = [&](std::size_t row, std::size_t i, std::size_t j) {
    return at(row, i) * at(row + 1, j) - at(row, j) * at(row + 1, i);
  };
  Dyadic determinant = minor(0, 0, 1) * minor(2, 2, 3) - minor(0, 0, 2) * minor(2, 1, 3);
  determinant += minor(0, 0, 3) * minor(2, 1, 2) + minor(0, 1, 2) * minor(2, 0, 3);
  determinant += minor(0, 2, 3) * minor(2, 0, 1) - minor(0, 1, 3) * minor(2, 0, 2);
  return determinant.sign() == 0;
}

tl::unexpected<InputError> refused(std::string what) { return tl::unexpected(InputError{.what = std::move(what)}); }

}  // namespace

template <class Scalar, int Dim>
Frustum<Scalar, Dim>::Frustum() {
  for (int plane = 0; plane < kFrustumPlanes<Dim>; ++plane) {
    auto& [normal, d] = planes_[plane];
    normal[plane / 2] = plane % 2 == 0 ? Scalar(-1) : Scalar(1);
    d = -1;
  }
}

template <class Scalar, int Dim>
tl::expected<Frustum<Scalar, Dim>, InputError> Frustum<Scalar, Dim>::make(const Planes& planes) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (const auto wrong = wrong_with(planes[i])) return refused(plane_said<Scalar, Dim>(i) + " " + *wrong);
  return Frustum(planes);
}

template <class Scalar, int Dim>
tl::expected<Frustum<Scalar, Dim>, InputError> frustum_of_camera(const FrustumCamera<Scalar, Dim>& camera) {
  if (!camera.position.allFinite()) return refused("the camera's position is not finite");
  if (!camera.axes.allFinite()) return refused("the camera's axes are not finite");
  if (!camera.half_tangents.allFinite() || camera.half_tangents.minCoeff() <= 0)
    return refused("the camera's half tangents are not all finite and above 0");
  if (!(0 < camera.near && camera.near < camera.far) || !std::isfinite(camera.far))
    return refused("the camera's near and far are not finite with 0 < near < far");
  typename Frustum<Scalar, Dim>::Planes planes;
  const Vector<Scalar, Dim> back = camera.axes.col(Dim - 1);
  const auto distance_of = [&](const Vector<Scalar, Dim>& normal) {
    Scalar sum = normal[0] * camera.position[0];
    for (int i = 1; i < Dim; ++i) sum += normal[i] * camera.position[i];
    return sum;
  };
  for (int axis = 0; axis < Dim - 1; ++axis)
    for (const int side : {0, 1}) {
      const Vector<Scalar, Dim> across =
          side == 0 ? Vector<Scalar, Dim>(-camera.axes.col(axis)) : camera.axes.col(axis);
      const Vector<Scalar, Dim> normal = across + camera.half_tangents[axis] * back;
      planes[2 * axis + side] = {normal, -distance_of(normal)};
    }
  const Scalar at = distance_of(back);
  planes[2 * Dim - 2] = {back, camera.near - at};
  planes[2 * Dim - 1] = {-back, at - camera.far};
  return Frustum<Scalar, Dim>::make(planes);
}

template <class Scalar>
tl::expected<typename Frustum<Scalar, 3>::Planes, InputError> planes_of_matrix(std::span<const Scalar> column_major,
                                                                               ClipDepth clip) {
  if (column_major.size() != 16)
    return refused("the matrix has " + std::to_string(column_major.size()) + " numbers where 16 belong");
  for (const Scalar entry : column_major)
    if (!std::isfinite(entry)) return refused("the matrix is not finite");
  const auto row_of = [&](std::size_t row, std::size_t column) { return column_major[4 * column + row]; };
  typename Frustum<Scalar, 3>::Planes planes;
  for (std::size_t i = 0; i < planes.size(); ++i) {  // outside is w + x < 0 or w - x < 0; if depth begins at 0, z < 0
    const bool from_zero = i == 4 && clip == ClipDepth::kFromZero;
    const auto entry = [&](std::size_t column) {
      const Scalar x = row_of(i / 2, column), w = row_of(3, column);
      if (from_zero) return -x;
      return i % 2 == 0 ? -(w + x) : x - w;
    };
    planes[i] = {{entry(0), entry(1), entry(2)}, entry(3)};
  }
  const Vector<Scalar, 3> view(row_of(3, 0), row_of(3, 1), row_of(3, 2));
  if (view.dot(planes[5].normal) < view.dot(planes[4].normal)) std::swap(planes[4], planes[5]);
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (planes[i].normal.isZero(0) && !(i == 5 && planes[i].d < 0))
      return refused("the matrix gives " + plane_said<Scalar, 3>(i) + " no normal, as for a plane at infinity");
  if (is_singular(column_major)) return refused("the matrix is singular");
  return planes;
}

template <class Scalar>
tl::expected<Frustum<Scalar, 3>, InputError> frustum_of_matrix(std::span<const Scalar> column_major, ClipDepth clip) {
  const auto planes = planes_of_matrix(column_major, clip);
  if (!planes) return tl::unexpected(planes.error());
  if (is_endless(*planes))
    return refused("the matrix gives " + plane_said<Scalar, 3>(5) + " no normal, as for a plane at infinity");
  return Frustum<Scalar, 3>::make(*planes);
}

template <class Scalar, int Dim>
Frustum<Scalar, Dim> Frustum<Scalar, Dim>::normalized() const {
  Planes planes = planes_;
  for (auto& [normal, d] : planes) {
    const Scalar length = scaled_norm<Scalar, Dim>(normal);
    normal /= length;
    d /= length;
  }
  return Frustum(planes);
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template class Frustum<Scalar, Dim>;                                                                                 \
  template tl::expected<Frustum<Scalar, Dim>, InputError> frustum_of_camera(const FrustumCamera<Scalar, Dim>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE
#define SNUG_INSTANTIATE(Scalar)                                                                                       \
  template tl::expected<Frustum<Scalar, 3>::Planes, InputError> planes_of_matrix(std::span<const Scalar>, ClipDepth);  \
  template tl::expected<Frustum<Scalar, 3>, InputError> frustum_of_matrix(std::span<const Scalar>, ClipDepth);
SNUG_INSTANTIATE(float)
SNUG_INSTANTIATE(double)
#undef SNUG_INSTANTIATE

}  // namespace snug
