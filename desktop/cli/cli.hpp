// The `snug` command. It knows of the window only how to ask for it, and so is built and tested without one.
#pragma once

#include "desktop/window.hpp"

namespace snug::desktop {

/// Runs what the arguments say; open_window: run_window. Returns the exit status: 0 done, 1 the answer of a check is
/// no, 2 bad input or usage, with one line on stderr for each thing that is wrong and nothing on stdout.
int run_command(int argc, const char* const* argv, int (*open_window)(const WindowOptions&));

}  // namespace snug::desktop
