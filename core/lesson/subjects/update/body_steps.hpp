// The facts of one update of a body's volume, as a lesson steps through them: those of the update itself (fit/update/),
// with the body's points in place of its hull's vertices.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "fit/update/updates.hpp"
#include "trace/fields.hpp"

namespace snug::lesson {

/// A point lies outside the AABB of those before it, which grows.
struct PointPlaced {
  static constexpr std::string_view kName = "point_placed";
  Index point = kNoIndex;
  SNUG_FIELDS(point);
};

/// The volume is updated. support: the points that it is known to touch.
struct VolumeUpdated {
  static constexpr std::string_view kName = "volume_updated";
  std::vector<Index> support;
  SNUG_FIELDS(support);
};

struct BodyStep {
  using Fact = std::variant<fit::ReachFound, PointPlaced, fit::NeighborsCompared, fit::ExtremeClimbed,
                            fit::BoundsRotated, fit::CenterMoved, fit::AxesTurned, VolumeUpdated>;
  int line = 0;             // of the update's pseudocode, counted from 0
  bool has_volume = false;  // whether volume is finished, or of a rebuilt AABB contains the points so far
  fit::Volume3 volume;      // in the world frame
  Fact fact;
};

}  // namespace snug::lesson
