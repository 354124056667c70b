// The bar on top of the window: which lesson, which size of text, which theme; and the keys' help card.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

void draw_header(Shell& shell, const app::Rect& rect);
/// What the keys do, over everything, while it is asked for.
void draw_keys(Shell& shell, const app::Rect& window);
/// What went wrong, over the stage, until it is clicked away.
void draw_notice(Shell& shell, const app::Rect& stage);

}  // namespace snug::desktop
