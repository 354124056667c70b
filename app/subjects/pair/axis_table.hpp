// The lecture's table of axes: a row each, filled in as they are tested, the one at hand lit.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// The lit row, counted from 0: the axis that the step speaks of. -1 for none.
[[nodiscard]] int lit_row(const lesson::Session& session);

/// The table below its heading, where there is an axis to be tested. Draws at a place and returns how high it is. Where
/// a question asks for an axis, a click on its row answers.
float draw_axis_panel(const Look& look, lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
