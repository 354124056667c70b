// Where the program finds what it comes with, in a build, installed, and in a folder that was unpacked anywhere.
#pragma once

#include <filesystem>

namespace snug::desktop {

/// The folder that lessons/ and assets/ are in: beside the program as it is built, in share/snug once it is installed.
[[nodiscard]] std::filesystem::path data_folder();

/// The window's program, likewise: beside the command, or in libexec/snug. It need not exist.
[[nodiscard]] std::filesystem::path window_program();

}  // namespace snug::desktop
