// What is known of the volumes around the points that were on the stage lately: the volumes, and what was measured.
// Edits of anything but the points, undo, and a way back to points that were measured lose nothing.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lesson/subject.hpp"
#include "measure/criteria_run.hpp"

namespace snug::lesson {

/// A volume around the points.
struct FittedVolume {
  const Method* method = nullptr;
  fit::Volume3 volume;
  std::optional<double> over_hull;  // its size over the convex hull's; none if that is flat
};

/// The volumes around one set of points.
struct ShapeCosts {
  AnyPointSet points;
  std::vector<FittedVolume> volumes;    // of each method that takes the points, in the lesson's order
  std::vector<cost::CriteriaRow> rows;  // what was measured of each; none before
};

/// The shapes that a subject and its clones had lately. They share it.
class ShapeStore {
 public:
  /// The shape with these points; it is fitted if it is new.
  [[nodiscard]] std::shared_ptr<ShapeCosts> shape(const AnyPointSet& points, const std::vector<const Method*>& methods,
                                                  std::uint64_t seed);

 private:
  std::vector<std::shared_ptr<ShapeCosts>> shapes_;  // the latest last
};

/// The catalogue's algorithms of these volumes.
[[nodiscard]] std::vector<const fit::Algorithm*> algorithms_of(const ShapeCosts& shape);

}  // namespace snug::lesson
