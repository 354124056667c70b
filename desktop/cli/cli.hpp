// The `snug` command. It opens the window only through a callback, so it is built and tested without one.
#pragma once

#include "desktop/window.hpp"

namespace snug::desktop {

/// Runs the command of the arguments. open_window: run_window. Returns the exit status: 0 done, 1 a check failed, 2
/// bad input or usage, with one line on stderr for each error and nothing on stdout.
int run_command(int argc, const char* const* argv, OpenWindow open_window);

}  // namespace snug::desktop
