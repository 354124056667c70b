// The table of axes (Ericson's table 4.1): one row for each, filled in as they are tested, with the current one lit.
#pragma once

#include <string>

#include "app/look.hpp"
#include "app/subjects/pair/table_unit.hpp"
#include "lesson/subjects/pair/axis_rows.hpp"

namespace snug::app {

/// The lit row, counted from 0: the axis that the step is about; -1 for none.
[[nodiscard]] int lit_row(const lesson::Session& session);

/// Which row is lit besides that of the step: the one that is pointed at, or was tapped, or that the prose marks.
struct AxisLight {
  int pointed = -1, tapped = -1;  // indices of rows
  std::string mark;
  [[nodiscard]] int row(int dim) const {
    return pointed >= 0 ? pointed : tapped >= 0 ? tapped : lesson::axis_of_mark(dim, mark);
  }
};

/// Draws the table below its heading, if the method tests axes, and returns its height. If a question asks for an axis,
/// a click on its row answers. unit: of its lengths. light: is told which row is pointed at; null if no row lights
/// anything.
float draw_axis_panel(const Look& look, lesson::Session& session, const TableUnit& unit, ImVec2 at, float width,
                      AxisLight* light = nullptr);

}  // namespace snug::app
