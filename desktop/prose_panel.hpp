// The columns beside the stage: at its left the lesson's prose, or the tools for the points; at its right, beneath the
// numbers, the pseudocode.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

void draw_prose_panel(Shell& shell, const app::Rect& rect);
void draw_code_panel(Shell& shell, const app::Rect& rect);

/// The tab with the tools for the points (point_tools.cpp).
class Column;
void draw_point_tools(Shell& shell, Column& column);

}  // namespace snug::desktop
