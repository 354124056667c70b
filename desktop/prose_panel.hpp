// The columns beside the stage: on the left the lesson's prose or the tools, with the controls of a cover below them;
// on the right, below the numbers or how volumes are stored, the pseudocode.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

void draw_prose_panel(Shell& shell, const app::Rect& rect);
void draw_cover_panel(Shell& shell, const app::Rect& rect);
void draw_code_panel(Shell& shell, const app::Rect& rect);

/// The tab with the tools.
class Column;
void draw_tools(Shell& shell, Column& column);
/// The tab with the scene's file. height: what the column has for it.
void draw_file(Shell& shell, Column& column, float height);
/// The tab with what is handed in of a lab sheet.
void draw_sheet(Shell& shell, Column& column);

}  // namespace snug::desktop
