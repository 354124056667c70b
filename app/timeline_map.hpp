// Maps steps to the timeline's track, and chooses the marks that have room.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lesson/exercise/sitting.hpp"
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

/// Whether that question has no answer yet; a question that a jump passed has none.
[[nodiscard]] bool is_open(const lesson::Session& session, const lesson::Asked& asked);

/// The marks that give no answer away: every question, and other marks up to the shown step or the first unanswered
/// question.
[[nodiscard]] std::vector<lesson::Mark> marks_to_show(const lesson::Session& session);

/// Whether a student may know how many decisions an exercise has: else that would tell where a test ends.
[[nodiscard]] bool count_known(const lesson::Exercise& exercise);

/// The furthest step that may be shown, that of the open decision, while the number of steps would tell where a test
/// ends; none where they may be counted. sitting: null for no exercise.
[[nodiscard]] std::optional<int> furthest_to_show(const lesson::Session& session, const lesson::Sitting* sitting);

/// The marks that are drawn: every question, every best, and those others that are at least `apart` pixels from these
/// and from the mark before.
[[nodiscard]] std::vector<lesson::Mark> marks_with_room(std::span<const lesson::Mark> marks, const TimelineMap& map,
                                                        float apart);

/// Where the flags of the questions stand, in their order: over their steps, or moved so that no two overlap.
[[nodiscard]] std::vector<float> flag_places(std::span<const lesson::Mark> marks, const TimelineMap& map, float apart);

}  // namespace snug::app
