// The system's own file dialog, asked for over D-Bus of the desktop's portal. libdbus is loaded if it is there, as it
// is wherever a session has a bus: the program runs without it, and then a path is typed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace snug::desktop {

/// Opens the dialog. endings: those of the files that it shows, without dots. proposed: the path of a file to save.
/// Returns false where there is no portal.
bool open_portal(const char* title, const std::vector<std::string>& endings, bool saves, const std::string& proposed);

struct PortalAnswer {
  enum class Kind : std::uint8_t {
    kWaits,
    kChosen,
    kCancelled,
    kNone
  } kind = Kind::kWaits;  // kNone: no portal answers
  std::string path;
};
/// What the dialog that was opened last has answered so far.
[[nodiscard]] PortalAnswer portal_answer();

}  // namespace snug::desktop
