// A chart as an SVG file: the same layout as on the screen, and words that are words, which can be searched, selected
// and read aloud.
#pragma once

#include <string>
#include <string_view>

#include "app/chart.hpp"

namespace snug::app {

/// look: of the fonts, sizes and palette. A light or dark palette makes a picture that is readable on either ground: it
/// has the colours of both, and whatever shows it selects. Each word's width is stated, so that another font in the
/// place of Inter leaves the layout as it is. width, height: of the picture, pixels; words and marks grow and
/// shrink with them (picture_scale). address: of what shows the chart; empty for none. ground: whether it has one.
[[nodiscard]] std::string chart_svg(const Look& look, float width, float height, const Chart& chart,
                                    std::string_view address = {}, bool ground = true);

}  // namespace snug::app
