// What the window shows while an edit takes long: what is done, how far, how long still, and Cancel. The session goes
// on with it in a thread, so that the window answers meanwhile.
#pragma once

#include <string>

#include "desktop/glfw_host.hpp"
#include "desktop/shell.hpp"
#include "desktop/state_file.hpp"

namespace snug::desktop {

/// Whether the session prepares an edit.
[[nodiscard]] bool is_working(Shell& shell);
/// Goes on until it is done, cancelled, or the window is closed. What it is refused for is the notice.
void work(GlfwHost& host, Shell& shell, StateFile& state);
/// What stands on the stage stays.
void cancel_working(Shell& shell);

/// "4 s so far, about 9 s left". left: in seconds; 0 if it is not known.
[[nodiscard]] std::string time_so_far(double seconds, double left);

}  // namespace snug::desktop
