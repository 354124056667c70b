// The planes of a view-projection matrix that is made and read in rounded arithmetic, as programs make it every frame.
// Source: G. Gribb, K. Hartmann, "Fast Extraction of Viewing Frustum Planes from the World-View-Projection Matrix",
// 2001. The careful planes are those of the camera itself (frustum_box.hpp).
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "lesson/subjects/frustum/frustum_box.hpp"
#include "query/cull/classify_steps.hpp"

namespace snug::lesson {

/// In double and in float. Only in space, for the matrix is 4 x 4.
inline constexpr std::array<std::string_view, 2> kMatrixTests{"matrix_planes", "matrix_planes_float"};

inline constexpr std::array<std::string_view, 6> kMatrixPseudocode{
    "M ← projection · view, in rounded numbers",  //
    "for each plane: row 4 of M ± row 1, 2 or 3",
    "  p-, n-vertex ← n's signs in the box",
    "  outside if n · n-vertex + d > 0",
    "  crosses ← yes if n · p-vertex + d > 0",
    "intersecting if so, else inside",
};

/// M = P V and its six planes, all in Scalar. Where near is so close to the camera that the far plane's normal is
/// rounded to 0, that plane is one that rejects nothing.
template <class Scalar>
[[nodiscard]] Frustum<Scalar, 3> matrix_frustum(const BoxPair& pair);

/// How far the far plane of these is from where it belongs.
struct FarPlane {
  double off = 0;               // along the camera's axis: above 0 too far, in per cent of the far distance
  double degrees = 0;           // how far it is tilted
  bool lost = false;            // it has no normal left
  std::vector<Point3> corners;  // where it cuts the frustum's sides; none if it is lost or cuts them behind the camera
};
/// test: one of kMatrixTests.
[[nodiscard]] FarPlane far_plane_of(std::string_view test, const BoxPair& pair);
[[nodiscard]] bool is_of_matrix(std::string_view test);

}  // namespace snug::lesson
