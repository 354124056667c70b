#include "lesson/subjects/frustum/frustum_box.hpp"

#include "lesson/words.hpp"

namespace snug::lesson {

FrustumCamera<double, 3> camera_of(const BoxPair& pair) {
  const Obb<double, 3>& box = pair.boxes[1];
  const double depth = 2 * box.half_extents[0], apex = depth * pair.taper / (1 - pair.taper);
  FrustumCamera<double, 3> camera;
  camera.near = apex;
  camera.far = apex + depth;
  camera.position = box.center - box.axes.col(0) * (depth / 2 + apex);
  const bool plane = pair.dim == 2;
  camera.axes.col(0) = plane ? Vector<double, 3>(-box.axes.col(1)) : Vector<double, 3>(box.axes.col(2));
  camera.axes.col(1) = box.axes.col(plane ? 2 : 1);
  camera.axes.col(2) = -box.axes.col(0);
  camera.half_tangents = {box.half_extents[plane ? 1 : 2] / camera.far, plane ? 1.0 : box.half_extents[1] / camera.far};
  return camera;
}

namespace {

template <int Dim>
tl::expected<Frustum<double, Dim>, InputError> frustum_in_double(const BoxPair& pair) {
  for (int axis = 0; axis < Dim; ++axis)
    if (!(pair.boxes[1].half_extents[axis] > 0))
      return tl::unexpected(InputError{.what = "a frustum's depth and far face must be above 0"});
  const FrustumCamera<double, 3> camera = camera_of(pair);
  if constexpr (Dim == 3) {
    return frustum_of_camera(camera);
  } else {
    FrustumCamera<double, 2> flat{.position = camera.position.head<2>(), .near = camera.near, .far = camera.far};
    flat.axes.col(0) = camera.axes.col(0).head<2>();
    flat.axes.col(1) = camera.axes.col(2).head<2>();
    flat.half_tangents[0] = camera.half_tangents[0];
    return frustum_of_camera(flat);
  }
}

}  // namespace

template <int Dim>
tl::expected<Frustum<double, Dim>, InputError> frustum_of(const BoxPair& pair) {
  auto frustum = frustum_in_double<Dim>(pair);
  if (!frustum || !pair.in_float) return frustum;
  const auto rounded = frustum_in<float>(*frustum);
  if (!rounded) return tl::unexpected(rounded.error());
  return frustum_in<double>(*rounded);
}
template tl::expected<Frustum<double, 2>, InputError> frustum_of<2>(const BoxPair&);
template tl::expected<Frustum<double, 3>, InputError> frustum_of<3>(const BoxPair&);

namespace {

template <int Dim>
std::vector<double> distances_from_planes(const BoxPair& pair) {
  std::vector<double> distances;
  const auto frustum = frustum_of<Dim>(pair);
  if (!frustum) return distances;
  const Vector<double, Dim> center = pair.boxes[0].center.head<Dim>();
  for (const Plane<double, Dim>& plane : frustum->planes())
    distances.push_back(signed_distance(plane, center) / plane.normal.norm());
  return distances;
}

}  // namespace

std::vector<double> center_distances(const BoxPair& pair) {
  return pair.dim == 2 ? distances_from_planes<2>(pair) : distances_from_planes<3>(pair);
}

std::pair<int, bool> face_on_plane(int dim, int plane) {
  const bool second = plane % 2 == 1;
  if (plane >= 2 * dim - 2) return {0, second};
  if (dim == 2) return {1, !second};
  return {plane < 2 ? 2 : 1, second};
}

std::string body_word(const BoxPair& pair) {
  if (pair.form == Form::kPoint) return "point";
  return pair.form == Form::kBall ? std::string(ball_word(pair.dim)) : "box";
}

std::string plane_name(int dim, int plane) {
  const std::size_t at = plane;
  return std::string(dim == 2 ? kFrustumPlaneNames<2>[at] : kFrustumPlaneNames<3>[at]);
}

std::string plane_names(int dim, PlaneSet planes) {
  std::string names;
  int count = 0;
  for (int plane = 0; plane < planes_of_frustum(dim); ++plane) {
    if ((planes >> plane & 1) == 0) continue;
    const bool is_last = planes >> (plane + 1) == 0;
    names += (count++ == 0 ? "the " : is_last ? " and " : ", ") + plane_name(dim, plane);
  }
  return names + (count == 1 ? " plane" : " planes");
}

std::string sign_name(int dim, int bits) {
  std::string signs;
  for (int axis = 0; axis < dim; ++axis) signs += (bits >> axis & 1) != 0 ? "+" : "−";
  return signs;
}

}  // namespace snug::lesson
