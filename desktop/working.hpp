// What the window shows while an edit takes long: what is done, how far, and Cancel.
#pragma once

#include "desktop/shell.hpp"

namespace snug::desktop {

/// Whether the session prepares an edit.
[[nodiscard]] bool is_working(Shell& shell);
/// Draws it over the whole window, in place of all else.
void draw_working(Shell& shell, const app::Rect& window, double now);
/// Goes on with it for a moment, after a frame was drawn. What it is refused for is the notice.
void go_on_working(Shell& shell);
/// What stands on the stage stays.
void cancel_working(Shell& shell);

}  // namespace snug::desktop
