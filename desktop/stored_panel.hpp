// "Stored as": how a volume on the stage is stored, in the place of the numbers.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// The tabs over the right column: "Stored as", "Numbers" and "Code".
void draw_side_tabs(Shell& shell, const app::Rect& rect);
void draw_stored_panel(Shell& shell, const app::Rect& rect);

}  // namespace snug::desktop
