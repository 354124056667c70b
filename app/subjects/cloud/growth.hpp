// The lengths of Ritter's formula, where a sphere grows to a point.
#pragma once

#include <string>
#include <vector>

#include "fit/any_step.hpp"
#include "lesson/subject.hpp"

namespace snug::app {

struct GrowthLength {
  enum class Of { kPoint, kBefore, kMove } of;  // whose colour it has
  lesson::Point3 from, to;                      // on the line through the old centre and the point
  bool above;                                   // on which side of the line it stands
  std::string words;                            // its name and its number
};

/// dist, radius and k, as the code of Ritter's growing step calls them; the new radius r stands at the sphere itself.
/// before: the sphere that the point lies outside of; now: the one that has grown to it.
[[nodiscard]] std::vector<GrowthLength> growth_lengths(const fit::Sphere3& before, const fit::Sphere3& now,
                                                       const lesson::Point3& point);

}  // namespace snug::app
