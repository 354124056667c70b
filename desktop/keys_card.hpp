// The card of all keys: those of the app's commands, of the menus, and of what the window has besides.
#pragma once

#include <vector>

#include "app/commands.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {

/// What the card lists now.
[[nodiscard]] std::vector<app::KeyRow> key_rows(Shell& shell);
/// Draws it over everything, while it is open. In a low window it has two columns, and scrolls if that is too little.
void draw_keys(Shell& shell, const app::Rect& window);

}  // namespace snug::desktop
