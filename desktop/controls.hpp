// The table of a cover, the situations and the sliders of a lesson, under its stage.
#pragma once

#include <string>

#include "desktop/shell.hpp"

namespace snug::desktop {

/// The height that they need in a width; 0 if the lesson has none.
[[nodiscard]] float controls_height(Shell& shell, const app::Look& look, float width);
void draw_controls(Shell& shell, const app::Rect& rect);
/// Moves the slider that the keyboard is on. Returns whether the key did that.
bool slide_by_key(Shell& shell, const std::string& key);

}  // namespace snug::desktop
