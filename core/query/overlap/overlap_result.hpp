// What an overlap test returns.
#pragma once

#include <optional>
#include <string_view>

#include "geometry/vector.hpp"

namespace snug::query {

/// A direction in which two volumes are apart.
template <class Scalar, int Dim>
struct SeparatingAxis {
  std::string_view kind;          // how it was found: "centers", "closest_points", "slab", "face_a", "edge_edge", ...
  Vector<Scalar, Dim> direction;  // unit, from the first volume towards the second
  Scalar gap = 0;                 // between their projections onto it, > 0, scene units
};

/// The result of an overlap test. Touching volumes overlap.
template <class Scalar, int Dim>
struct OverlapResult {
  bool overlap = false;
  std::optional<Scalar> distance;  // 0 if they overlap; none if the test does not find it (see kPairTests)
  std::optional<SeparatingAxis<Scalar, Dim>> separating_axis;  // none if they overlap, or if one is empty
  int tests = 0;  // axes tried, pairs of features compared, simplices of GJK
};

/// The same answer with the volumes in the other order.
template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> flipped(OverlapResult<Scalar, Dim> result) {
  if (!result.separating_axis) return result;
  auto& [kind, direction, gap] = *result.separating_axis;
  direction = -direction;
  if (kind == "face_a" || kind == "face_b") kind = kind == "face_a" ? "face_b" : "face_a";
  return result;
}

}  // namespace snug::query
