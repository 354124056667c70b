// Draws a chart as SVG, which needs no display.
#pragma once

#include <string>

#include "app/chart.hpp"

namespace snug::desktop {

/// font: as in app::Platform. width, height: pixels. ground: whether it has one.
[[nodiscard]] std::string svg_of(const app::Chart& chart, float width, float height, app::Theme theme,
                                 std::string (*font)(std::string_view name), bool ground);

}  // namespace snug::desktop
