// The view frustum, which is what a camera sees: the intersection of half-spaces whose normals point out.
// Source: G. Gribb, K. Hartmann, "Fast Extraction of Viewing Frustum Planes from the World-View-Projection Matrix",
// 2001, for the planes of a matrix.
//
// A frustum is its planes as they are stored, to the last bit: every exact decision is about these. Making them from a
// camera or a matrix rounds each number once or a few times, so that a plane at distance D from the origin is rotated
// by a few u and moved by a few u of D. Nothing else rounds: planes are normalised only on request
// (Frustum::normalized), and no test needs that.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "geometry/plane.hpp"
#include "geometry/vector.hpp"

namespace snug {

/// How many planes a frustum has: 4 lines in 2-D.
template <int Dim>
inline constexpr int kFrustumPlanes = 2 * Dim;

/// The planes' order. Opposite planes are neighbours: 2 i and 2 i + 1.
template <int Dim>
inline constexpr std::array<std::string_view, 2 * Dim> kFrustumPlaneNames = [] {
  if constexpr (Dim == 2) return std::array<std::string_view, 4>{"left", "right", "near", "far"};
  else return std::array<std::string_view, 6>{"left", "right", "bottom", "top", "near", "far"};
}();

/// A set of a frustum's planes: bit i for plane i.
using PlaneSet = std::uint32_t;
template <int Dim>
inline constexpr PlaneSet kAllPlanes = (PlaneSet{1} << kFrustumPlanes<Dim>)-1;

/// All p with normal . p + d <= 0 for each plane. make checks that every normal is finite and not zero.
template <class Scalar, int Dim>
class Frustum {
 public:
  using Planes = std::array<Plane<Scalar, Dim>, kFrustumPlanes<Dim>>;

  /// The largest coordinate of a normal is at most this and at least its inverse, and |d| is at most four times this,
  /// times that coordinate. So with volumes within PointSet's limits nothing overflows, and underflow is smaller than
  /// every error bound.
  static constexpr Scalar kLargest = sizeof(Scalar) == 8 ? static_cast<Scalar>(0x1p508) : static_cast<Scalar>(0x1p60);

  /// The square (in space the cube) from -1 to 1.
  Frustum();

  /// In the order of kFrustumPlaneNames, normals pointing out, of any length. Together the planes may be unbounded.
  /// Errors: a number that is not finite, a normal that is zero, too short or too long, a plane too far away (each says
  /// which plane).
  static tl::expected<Frustum, InputError> make(const Planes& planes);

  /// The same planes with unit normals, within 4u, so that signed_distance is a distance. This is a slightly different
  /// frustum: each plane is rotated by up to 4u, and its distance from the origin scaled by as much. A point at
  /// distance D from the origin may lie 8u D to the other side of it.
  [[nodiscard]] Frustum normalized() const;

  [[nodiscard]] const Planes& planes() const { return planes_; }
  [[nodiscard]] const Plane<Scalar, Dim>& operator[](int plane) const { return planes_[plane]; }

 private:
  explicit Frustum(const Planes& planes) : planes_(planes) {}
  Planes planes_;
};

/// A camera. It looks along minus the last of its axes, as OpenGL's do.
template <class Scalar, int Dim>
struct FrustumCamera {
  Vector<Scalar, Dim> position = Vector<Scalar, Dim>::Zero();  // scene units
  Matrix<Scalar, Dim> axes = Matrix<Scalar, Dim>::Identity();  // columns: right, in 3-D up, back; unit, perpendicular
  /// The tangents of half the angle of view, sideways and in 3-D upwards: 1 sees 90 degrees. > 0
  Vector<Scalar, Dim - 1> half_tangents = Vector<Scalar, Dim - 1>::Ones();
  Scalar near = Scalar(0.1);  // scene units along the view, 0 < near < far
  Scalar far = 100;
};

/// What a camera sees. Planes at the sides have normals of length sqrt(1 + tangent^2). Each coordinate of a normal
/// carries two roundings; each d carries those of a dot product with the position, which may move a plane by u of the
/// position's size. Errors: a number that is not finite, near and far that are not 0 < near < far, a tangent that is
/// not positive, and what Frustum::make refuses.
template <class Scalar, int Dim>
[[nodiscard]] tl::expected<Frustum<Scalar, Dim>, InputError>
frustum_of_camera(const FrustumCamera<Scalar, Dim>& camera);

/// Where the depth of a clip space begins: -w <= z <= w, as of OpenGL, or 0 <= z <= w, as of Direct3D, Metal, Vulkan
/// and WebGPU. Reversed depth (1 near, 0 far) needs no name of its own: w grows along the view and tells near from far.
/// A parallel projection's w does not grow: its near plane is then the one where depth begins.
enum class ClipDepth : std::uint8_t { kFromMinusOne, kFromZero };

/// The planes of what a view-projection matrix maps into clip space, -w <= x, y <= w. They are sums and differences of
/// its rows, in Scalar: each number carries one rounding. A far plane at infinity is all zero but for d: is_endless.
/// column_major: 16 numbers, the matrix that takes world to clip coordinates, its columns one after the other. Errors:
/// not 16 numbers, one that is not finite, a matrix that is singular (exactly), another plane without a normal.
template <class Scalar>
[[nodiscard]] tl::expected<typename Frustum<Scalar, 3>::Planes, InputError>
planes_of_matrix(std::span<const Scalar> column_major, ClipDepth clip = ClipDepth::kFromMinusOne);

/// The frustum of these planes. Errors: those, a far plane at infinity, and what Frustum::make refuses.
template <class Scalar>
[[nodiscard]] tl::expected<Frustum<Scalar, 3>, InputError> frustum_of_matrix(std::span<const Scalar> column_major,
                                                                             ClipDepth clip = ClipDepth::kFromMinusOne);

/// Whether the far plane lies at infinity: its normal is zero.
template <class Scalar, std::size_t planes, int Dim>
[[nodiscard]] bool is_endless(const std::array<Plane<Scalar, Dim>, planes>& all) {
  return all.back().normal.isZero(0);
}

/// Endless planes with a far plane that makes no difference to volumes of coordinates up to `size`: parallel to the
/// near plane, and beyond both.
template <class Scalar, std::size_t planes, int Dim>
[[nodiscard]] std::array<Plane<Scalar, Dim>, planes> ended_beyond(std::array<Plane<Scalar, Dim>, planes> all,
                                                                  Scalar size) {
  const auto& [normal, d] = all[planes - 2];
  const Scalar beyond = 2 * (normal.template lpNorm<1>() * size + std::abs(d));
  all.back() = {-normal, beyond > 0 ? -beyond : -normal.template lpNorm<1>()};
  return all;
}

}  // namespace snug
