// The inspector's figures of a scene, frame by frame.
#pragma once

#include <vector>

#include "lesson/figures.hpp"

namespace snug::lesson {

/// Keys: frame all_pairs after_broad after_loose touching slack cost energy.
[[nodiscard]] std::vector<Figure> scene_figures(const RunView& run);

/// "12 pairs", "35.0 %": a figure of scene_figure_names() with its unit.
[[nodiscard]] std::string scene_figure_text(std::string_view figure, double value);

}  // namespace snug::lesson
