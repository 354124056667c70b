// The bar at the top of the window: lesson, text size and theme; and what lies over the stage for a moment.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

void draw_header(Shell& shell, const app::Rect& rect);
/// Draws what is being read, with a button that cancels it.
void draw_loading(Shell& shell, const app::Rect& stage);
/// Draws the notice over the stage, until it is dismissed.
void draw_notice(Shell& shell, const app::Rect& stage);

}  // namespace snug::desktop
