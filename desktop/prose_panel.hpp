// The column beside the stage: the lesson's prose, what it asks, its pseudocode; and the tools for the points.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

void draw_prose_panel(Shell& shell, const app::Rect& rect);

/// The tab with the tools for the points (point_tools.cpp).
class Column;
void draw_point_tools(Shell& shell, Column& column);

}  // namespace snug::desktop
