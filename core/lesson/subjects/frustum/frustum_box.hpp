// A body and a frustum on the stage, stored as a pair of boxes (boxes.hpp) whose second one tapers. The body is a box,
// a ball or a point. Its axis 0 is the
// camera's viewing direction, half_extents[0] is half of the depth, the others are half of the far face; the near face
// is taper times as wide.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "geometry/frustum.hpp"
#include "lesson/boxes.hpp"

namespace snug::lesson {

/// The camera of the frustum. In 2-D the plane is seen from above: right is minus B's axis 1, and up is meaningless.
/// In 3-D axis 1 is up and axis 2 right. pair: with a frustum; if the frustum is flat, the numbers need not be
/// finite.
[[nodiscard]] FrustumCamera<double, 3> camera_of(const BoxPair& pair);

/// In float its planes are rounded to float. Errors: a depth or a far face of 0, and what frustum_of_camera refuses.
template <int Dim>
[[nodiscard]] tl::expected<Frustum<double, Dim>, InputError> frustum_of(const BoxPair& pair);

/// The same planes in another scalar. Errors: those of Frustum::make.
template <class Scalar, class From, int Dim>
[[nodiscard]] tl::expected<Frustum<Scalar, Dim>, InputError> frustum_in(const Frustum<From, Dim>& frustum) {
  typename Frustum<Scalar, Dim>::Planes planes;
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes[i] = {frustum.planes()[i].normal.template cast<Scalar>(), static_cast<Scalar>(frustum.planes()[i].d)};
  return Frustum<Scalar, Dim>::make(planes);
}

/// The face of B on a plane of the frustum: the axis that it is perpendicular to, and whether on its positive side.
[[nodiscard]] std::pair<int, bool> face_on_plane(int dim, int plane);

/// The body's centre in the equation of each plane, n . c + d with unit normals: positive outside. None where there is
/// no frustum.
[[nodiscard]] std::vector<double> center_distances(const BoxPair& pair);

/// 4 in 2-D, 6 in 3-D.
[[nodiscard]] inline int planes_of_frustum(int dim) { return 2 * dim; }
/// "box", "point", and of a ball "circle" or "sphere".
[[nodiscard]] std::string body_word(const BoxPair& pair);

/// "left".
[[nodiscard]] std::string plane_name(int dim, int plane);
/// "the left and near planes".
[[nodiscard]] std::string plane_names(int dim, PlaneSet planes);

/// A vertex as its signs along the box's axes, which are those of the normals that select it: "+−", "−++".
[[nodiscard]] std::string sign_name(int dim, int bits);

}  // namespace snug::lesson
