// The Minkowski difference A - B of two volumes' cores, in which GJK looks for the point nearest to the origin.
#pragma once

#include "lesson/subjects/pair/volumes.hpp"

namespace snug::lesson {

/// A vertex of A - B: a vertex of A's core minus one of B's.
struct DifferenceVertex {
  Index a = kNoIndex, b = kNoIndex;
  Point3 at = Point3::Zero();
};

/// In the plane: the vertices of its outline, counter-clockwise. None where a core is smooth or empty.
[[nodiscard]] std::vector<DifferenceVertex> difference_outline(const VolumePair& pair);

/// Vertices of A - B by their indices in pairs, as query::NearestFound has them.
[[nodiscard]] std::vector<Point3> difference_points(const VolumePair& pair, std::span<const Index> corners);

/// The point nearest to the origin of the simplex that these 1 to 4 points span.
[[nodiscard]] Point3 nearest_of(std::span<const Point3> simplex);

}  // namespace snug::lesson
