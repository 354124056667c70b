// Where two volumes are nearest.
#pragma once

#include "lesson/subjects/pair/volumes.hpp"

namespace snug::lesson {

/// The nearest points of both, A's first. Where they overlap, those that would touch if B were moved out of A, from
/// centre to centre; B's point is the farther inside A, the deeper they overlap. Source: GJK, and bisection.
[[nodiscard]] std::array<Point3, 2> gap_of(const VolumePair& pair);
/// Two boxes as volumes.
[[nodiscard]] VolumePair as_volumes(const BoxPair& boxes);

}  // namespace snug::lesson
