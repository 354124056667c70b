// Steps along the timeline's track, and which of its marks have room.
#pragma once

#include <span>
#include <vector>

#include "lesson/session.hpp"

namespace snug::app {

/// From x = left (before the first step) to left + width (after the last).
struct TimelineMap {
  float left = 0, width = 1;
  int steps = 1;

  [[nodiscard]] float x_of(int step) const;
  /// The step nearest to x, within 0 ... steps.
  [[nodiscard]] int step_at(float x) const;
};

/// The marks that are drawn: every question, and of the others those that stand clear of the one before by `apart` pixels.
[[nodiscard]] std::vector<lesson::Mark> marks_with_room(std::span<const lesson::Mark> marks, const TimelineMap& map,
                                                        float apart);

}  // namespace snug::app
