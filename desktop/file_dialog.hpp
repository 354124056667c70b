// Asks for a file: by the system's own dialog where a portal runs, or else by a card with a path to type.
#pragma once

#include "app/widgets.hpp"
#include "desktop/file_card.hpp"

namespace snug::desktop {

class Shell;

/// Asks for the path of a file to open or to save, and then does so. The window answers meanwhile.
void ask_path(Shell& shell, FileCard::What what);
/// What the system's dialog has answered since the last call. Returns whether it is still open.
bool poll_dialog(Shell& shell);
/// The card, while it is open; over everything.
void draw_file_card(Shell& shell, const app::Rect& window);

}  // namespace snug::desktop
