// The inspector's figures of a scene, frame by frame.
#pragma once

#include <vector>

#include "lesson/figures.hpp"
#include "scene/scene.hpp"

namespace snug::lesson {

/// Keys: frame all_pairs after_broad after_loose touching slack cost energy.
[[nodiscard]] std::vector<Figure> scene_figures(const RunView& run);

/// "12 pairs", "35.0 %": a figure of scene_figure_names() with its unit.
[[nodiscard]] std::string scene_figure_text(std::string_view figure, double value);

/// What one run took in the mean, microseconds: "3.2", or "< 20" where that is more than the clock can tell; "" where
/// there was none. clock_step: the least that the clock goes on by, ns. A run's time is off by less than such a step
/// either way, and n of them together by some sqrt(n) / 2 steps.
[[nodiscard]] std::string effect_time_text(const scene::Tally& tally, double clock_step);

}  // namespace snug::lesson
