// What an overlap test gives back.
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

/// Touching volumes overlap.
template <class Scalar, int Dim>
struct OverlapResult {
  bool overlap = false;
  std::optional<Scalar> distance;  // 0 where they overlap; none where the test does not find it (see kPairTests)
  std::optional<SeparatingAxis<Scalar, Dim>> separating_axis;  // none where they overlap, or where one is empty
  int tests = 0;  // axes tried, pairs of features compared, simplices of GJK
};

/// The same answer, the other volume named first.
template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> flipped(OverlapResult<Scalar, Dim> result) {
  if (!result.separating_axis) return result;
  auto& [kind, direction, gap] = *result.separating_axis;
  direction = -direction;
  if (kind == "face_a" || kind == "face_b") kind = kind == "face_a" ? "face_b" : "face_a";
  return result;
}

}  // namespace snug::query
