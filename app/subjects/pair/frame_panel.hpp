// What the table of axes is computed from: the matrix R, the vector t and both boxes' half extents, and the formulas of
// a row, with its entries lit.
#pragma once

#include <optional>

#include "app/panel_words.hpp"
#include "app/subjects/pair/axis_table.hpp"

namespace snug::app {

/// Draws them if the method tests axes, and returns their height. The row that is lit by light or else the step's gives
/// the formulas.
/// While a question asks for entries of R, a click on one picks it.
float draw_frame_panel(const Look& look, lesson::Session& session, const AxisLight& light, ImVec2 at, float width);
/// The same numbers in words; none if the method tests no axes.
[[nodiscard]] std::optional<PanelWords> frames_in_words(const lesson::Session& session);

}  // namespace snug::app
