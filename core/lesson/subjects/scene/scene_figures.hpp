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

/// Keys: frame all_pairs compared after_broad after_loose touching swaps slack over_hull cost energy.
/// points: those of the body. sorts: whether the search for pairs sorts the AABBs.
[[nodiscard]] std::vector<Figure> scene_figures(const FrameStep& step, const AnyPointSet& points, bool sorts);

/// The key of the volume divided by the hull's: the same yardstick for every kind of volume.
inline constexpr std::string_view kOverHull = "over_hull";

/// A figure of a step by its key: one of scene_figure_names(), or over_hull. points: those of the body.
[[nodiscard]] double value_of(const FrameStep& step, std::string_view key, const AnyPointSet& points);

/// That figure for a body of points. points: in any pose, because a hull's volume is the same in every pose. Infinite
/// if they are flat. O(n log n) time.
[[nodiscard]] double over_hull(const fit::Volume3& volume, const AnyPointSet& points);

/// A figure of scene_figure_names(), or over_hull, with its unit: "12 pairs", "+35.0 %", "3.421 times"; a dash if it is
/// infinite.
[[nodiscard]] std::string scene_figure_text(std::string_view figure, double value);

/// A row of the inspector; it is not known if its value is infinite.
[[nodiscard]] Figure scene_figure(std::string_view key, double value);

/// "35.0 % larger than the tightest"; from twice as large on, "4.8 times the tightest (+385 %)".
[[nodiscard]] std::string looser_words(double slack, std::string_view than);

/// The title of a figure of scene_figure_names(), or of over_hull: "Touching".
[[nodiscard]] std::string_view scene_figure_title(std::string_view figure);

/// An effect's name in words: "broad phase".
[[nodiscard]] std::string effect_words(std::string name);

/// The mean time of one run, microseconds: "3.2", or "< 20" if the clock cannot resolve it; "" if there was no run.
/// clock_step: the smallest step of the clock, ns. A run's time is off by less than one such step either way, and the
/// sum of n runs by about sqrt(n) / 2 steps.
[[nodiscard]] std::string effect_time_text(const scene::EffectTally& tally, double clock_step);

}  // namespace snug::lesson
