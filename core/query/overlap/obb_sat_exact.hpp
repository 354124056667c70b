// Decides the axes of the separating-axis test that rounding left open, in exact arithmetic.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/obb.hpp"
#include "query/overlap/sat_steps.hpp"

namespace snug::query {

/// The entry at an index of Ericson's table 4.1, counted from 0: A's faces, B's faces, edges of A x edges of B.
struct AxisAt {
  AxisKind kind;
  int i, j;  // -1 for none
};
template <int Dim>
[[nodiscard]] constexpr AxisAt axis_at(int place) {
  if (place < Dim) return {AxisKind::kFaceA, place, -1};
  if (place < 2 * Dim) return {AxisKind::kFaceB, -1, place - Dim};
  return {AxisKind::kEdgeEdge, (place - 2 * Dim) / Dim, (place - 2 * Dim) % Dim};
}

/// A set of axes: bit i for the axis with index i.
using AxisSet = std::uint32_t;

/// Returns the axis of the set along which the boxes are farthest apart, or none if they are apart along none of them.
/// It is exact on the numbers as they are: a box is the set of all center + sum s_i h_i u_i with |s_i| <= 1, and a
/// face's normal is the cross product of its edges' directions, even if the axes u_i are not exactly perpendicular. The
/// axes together decide every case, including flat boxes, segments and points: the difference of two boxes is a
/// zonotope of up to six generators, and its facets' normals are cross products of two generators. The axes must be
/// linearly independent, within 10 per cent of unit length.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<SatAxis<Scalar, Dim>> separating_exactly(const Obb<Scalar, Dim>& a,
                                                                     const Obb<Scalar, Dim>& b, AxisSet axes);

}  // namespace snug::query
