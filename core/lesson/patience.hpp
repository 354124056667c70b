// What a lesson would have to compute for new points is estimated before it is begun: nobody waits for a page that
// answers nothing.
#pragma once

#include <array>
#include <functional>

#include "lesson/subject.hpp"

namespace snug::lesson {

/// How long a lesson may take to show new points, ns.
inline constexpr double kLongestShown = 10e9;

/// What is known of a computation before it is run on all of n points.
struct Estimate {
  double whole = 0;  // ns on all of them
  Index most = 0;    // about how many take kLongestShown; n if all take less
};

/// Runs it on more and more of the points, doubling, and follows the growth. It stops where that is certain to be too
/// long, and at an eighth of the points. time_of: runs it on so many of them and returns the time, ns. n: at least 1.
[[nodiscard]] Estimate estimate_of(const std::function<double(Index)>& time_of, Index n);

/// Refuses a subject of whose points the lesson's runs and comparison would take longer than that, and says how many
/// they could be. methods: those that it will run; null for none. Without a clock, and for few points, nothing is
/// refused.
[[nodiscard]] Done check_patience(const Lesson& lesson, const Subject& next,
                                  const std::array<const Method*, 2>& methods, Clock clock);

}  // namespace snug::lesson
