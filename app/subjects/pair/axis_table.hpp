// The lecture's table of axes: one row for each, filled in as they are tested, with the current one lit.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// The lit row, counted from 0: the axis that the step is about; -1 for none.
[[nodiscard]] int lit_row(const lesson::Session& session);

/// Draws the table below its heading, if the method tests axes, and returns its height. If a question asks for an axis,
/// a click on its row answers.
float draw_axis_panel(const Look& look, lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
