// A box and a frustum on the stage, held as a pair of boxes (boxes.hpp) whose second one tapers: its axis 0 is the way
// that the camera looks, half_extents[0] half of the depth, the others half of the far face; the near face is taper
// times as wide.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "geometry/frustum.hpp"
#include "lesson/boxes.hpp"

namespace snug::lesson {

/// Whether the pair is a box and a frustum.
[[nodiscard]] inline bool has_frustum(const BoxPair& pair) { return pair.taper < 1; }

/// The camera that sees the frustum. In 2-D one looks at the plane from above: right is minus B's axis 1, and nothing
/// is said of up. In 3-D axis 1 is up and axis 2 right. pair: with a frustum; of a flat one, the numbers need not be
/// finite.
[[nodiscard]] FrustumCamera<double, 3> camera_of(const BoxPair& pair);

/// Errors: a depth or a far face of 0, and what frustum_of_camera refuses.
template <int Dim>
[[nodiscard]] tl::expected<Frustum<double, Dim>, InputError> frustum_of(const BoxPair& pair);

/// The face of B that lies on a plane of the frustum: the axis that it stands across, and whether on its positive side.
[[nodiscard]] std::pair<int, bool> face_on_plane(int dim, int plane);

/// 4 in 2-D, 6 in 3-D.
[[nodiscard]] inline int planes_of_frustum(int dim) { return 2 * dim; }
/// "left".
[[nodiscard]] std::string plane_name(int dim, int plane);
/// "the left and near planes".
[[nodiscard]] std::string plane_names(int dim, PlaneSet planes);

/// A corner as the signs of its way from the centre, which are those of the normals that choose it: "+−", "−++".
[[nodiscard]] std::string sign_name(int dim, int bits);

}  // namespace snug::lesson
