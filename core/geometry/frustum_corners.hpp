// The vertices of a frustum, computed from its planes.
#pragma once

#include <array>
#include <cstddef>
#include <tl/expected.hpp>

#include "geometry/frustum.hpp"
#include "number/dyadic.hpp"

namespace snug {

/// How many there are: one for each choice of left or right, (in 3-D) bottom or top, and near or far.
template <int Dim>
inline constexpr std::size_t kFrustumCorners = std::size_t{1} << Dim;

/// Corner c lies on the planes 2 i + bit i of c: bit 1 for right and not left, in 3-D 2 for top and not bottom, the
/// highest bit for far and not near. Each coordinate is within 8u of the exact one's size.
template <class Scalar, int Dim>
using FrustumCorners = std::array<Vector<Scalar, Dim>, kFrustumCorners<Dim>>;

/// Errors: planes that should meet in a vertex do not; the planes enclose nothing, or not all of them bound it, or its
/// shape is not a box in perspective (a vertex outside another plane, or more vertices than these); a vertex beyond
/// every Scalar. All of this is decided exactly.
template <class Scalar, int Dim>
[[nodiscard]] tl::expected<FrustumCorners<Scalar, Dim>, InputError> corners_of(const Frustum<Scalar, Dim>& frustum);

/// The point coordinates / weight, exactly. weight > 0.
template <int Dim>
struct ExactPoint {
  std::array<Dyadic, Dim> coordinates;
  Dyadic weight;
};

/// The same vertices without rounding. Errors: the same, except vertices beyond every Scalar.
template <class Scalar, int Dim>
[[nodiscard]] tl::expected<std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>, InputError>
exact_corners_of(const Frustum<Scalar, Dim>& frustum);

}  // namespace snug
