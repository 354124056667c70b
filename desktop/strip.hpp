// What is wrong with a lesson that is being written, in a strip over its stage.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// Measures its height for the next frame.
void draw_strip(Shell& shell, const app::Rect& rect);

}  // namespace snug::desktop
