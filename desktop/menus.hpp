// The menus in the bar: File, Edit, View, Lesson, Help; in a narrow bar one menu with all of them.
#pragma once

#include <string>
#include <vector>

#include "app/commands.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {

/// Draws the menus' words from x on; right: where the bar's tools begin. Returns where they end.
float draw_menus(Shell& shell, const app::Rect& bar, float x, float right);
/// Runs the command of a menu by its key, as the browser names it. Returns whether it is one.
bool menu_by_key(Shell& shell, const std::string& key, bool shift, bool control);
/// The rows for the card of keys of what is not one of the app's own commands.
[[nodiscard]] std::vector<app::KeyRow> keys_of_menus(Shell& shell);

/// The card About, with the version and the licences.
void draw_about(Shell& shell, const app::Rect& window);

}  // namespace snug::desktop
