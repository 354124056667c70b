// The inspector's figures of a scene, frame by frame.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/figures.hpp"
#include "lesson/subjects/scene/frame_steps.hpp"
#include "scene/scene.hpp"

namespace snug::lesson {

/// Keys: frame all_pairs compared after_broad after_loose touching slack over_hull cost energy.
/// points: those of which the body at hand is.
[[nodiscard]] std::vector<Figure> scene_figures(const FrameStep& step, const AnyPointSet& points);

/// The key of how many times the volume of its convex hull a body's volume has: one yardstick for every kind.
inline constexpr std::string_view kOverHull = "over_hull";

/// That figure, of the points of which a body is. points: where they are does not matter, for a hull's volume is the
/// same in every pose. Infinite where they are flat. O(n log n) time.
[[nodiscard]] double over_hull(const fit::Volume3& volume, const AnyPointSet& points);

/// "12 pairs", "+35.0 %", "3.421 times": a figure of scene_figure_names(), or over_hull, with its unit; a dash where it
/// is infinite.
[[nodiscard]] std::string scene_figure_text(std::string_view figure, double value);

/// The same of a bound, which is exact and has no sign: "10 %", "1,000 %".
[[nodiscard]] std::string scene_bound_text(std::string_view figure, double value);

/// "35.0 % larger than the tightest"; of what is more than twice as large "4.8 times the tightest (+385 %)".
[[nodiscard]] std::string looser_words(double slack, std::string_view than);

/// "Touching": what a figure of scene_figure_names(), or over_hull, is called.
[[nodiscard]] std::string_view scene_figure_title(std::string_view figure);

/// An effect's name in words: "broad phase".
[[nodiscard]] std::string effect_words(std::string name);

/// The ranges between rising bounds: "none", "1 to 8 points", "9 to 79 points", "more than 79 points"; of what is no
/// count "at most 10 %", "10 % to 100 %".
[[nodiscard]] std::vector<std::string> scene_range_texts(std::string_view figure, std::span<const double> bounds);

/// What one run took in the mean, microseconds: "3.2", or "< 20" where that is more than the clock can tell; "" where
/// there was none. clock_step: the least that the clock goes on by, ns. A run's time is off by less than such a step
/// either way, and n of them together by some sqrt(n) / 2 steps.
[[nodiscard]] std::string effect_time_text(const scene::Tally& tally, double clock_step);

}  // namespace snug::lesson
