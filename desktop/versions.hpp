// What the program is built and runs with, for Help and for who reports a fault.
#pragma once

#include <string>

namespace snug::desktop {

/// Names and versions in one sentence without its full stop, the graphics driver's last. Needs a current OpenGL
/// context.
[[nodiscard]] std::string versions_of_parts();

}  // namespace snug::desktop
