// The corners of a frustum, which its planes only imply.
#pragma once

#include <array>
#include <cstddef>
#include <tl/expected.hpp>

#include "geometry/frustum.hpp"
#include "number/dyadic.hpp"

namespace snug {

/// How many: where each of the lines left or right, (in 3-D) bottom or top, near or far is chosen.
template <int Dim>
inline constexpr std::size_t kFrustumCorners = std::size_t{1} << Dim;

/// Corner c lies on the planes 2 i + bit i of c: bit 1 for right and not left, in 3-D 2 for top and not bottom, the
/// highest bit for far and not near. Rounded from the exact ones, each coordinate within 8u of its size.
template <class Scalar, int Dim>
using FrustumCorners = std::array<Vector<Scalar, Dim>, kFrustumCorners<Dim>>;

/// Errors: opposite planes or others that should meet in a corner do not; the planes leave nothing, or only what some
/// planes do not bound or bound otherwise than as a box seen in perspective (corners outside of other planes, more
/// corners than these); a corner beyond every Scalar. All decided exactly.
template <class Scalar, int Dim>
[[nodiscard]] tl::expected<FrustumCorners<Scalar, Dim>, InputError> corners_of(const Frustum<Scalar, Dim>& frustum);

/// A point that is coordinates / weight, exactly. weight > 0.
template <int Dim>
struct ExactPoint {
  std::array<Dyadic, static_cast<std::size_t>(Dim)> coordinates;
  Dyadic weight;
};

/// The same corners without rounding. Errors: the same, but for corners that are far out.
template <class Scalar, int Dim>
[[nodiscard]] tl::expected<std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>, InputError>
exact_corners_of(const Frustum<Scalar, Dim>& frustum);

}  // namespace snug
