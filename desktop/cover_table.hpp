// The table of a cover, under its stage: a head sorts by its column, a row is chosen by a click.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// Its height; 0 if the open lesson has none that everyone sees.
[[nodiscard]] float cover_table_height(Shell& shell, const app::Look& look, float width);
void draw_cover_table(Shell& shell, const app::Rect& rect);

}  // namespace snug::desktop
