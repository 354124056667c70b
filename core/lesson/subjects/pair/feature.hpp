// Which feature of a lozenge's rectangle the nearest point of its core lies on.
#pragma once

#include "lesson/subjects/pair/volumes.hpp"

namespace snug::lesson {

struct RectangleFeature {
  enum class Kind { kVertex, kEdge, kFace } kind = Kind::kFace;
  std::vector<Point3> corners;  // its one, two or four vertices, in order around it
};

/// at: a point of the rectangle, within rounding.
[[nodiscard]] RectangleFeature feature_at(const Lozenge<double, 3>& lozenge, const Point3& at);

/// "feature": which feature of B's rectangle is nearest to A's core. Every other kind of core comes before rectangles,
/// so B has one if any has.
const char* offer_features(Asked& asked, const Run& run);
Truth feature_truth(const Asked& asked, const Run& run);

}  // namespace snug::lesson
