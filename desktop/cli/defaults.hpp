// A class's defaults: the file snug.toml, with which whoever looks after the machines sets what every student begins
// with.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"

namespace snug::desktop {

/// Empty where the file says nothing, or where there is none.
struct Defaults {
  std::string file;
  std::filesystem::path lessons;  // in place of the program's own
  std::filesystem::path results;  // where the window saves what students hand in, pictures and tables
  std::string theme;              // light, dark, contrast or projector
  std::string first_lesson;       // what a student sees who was not here before
  std::string page;               // the address of the class's page, for codes that lead there
};

/// Reads the first snug.toml there is: in snug/ of the user's and of the system's configuration (XDG_CONFIG_HOME,
/// XDG_CONFIG_DIRS), then beside the lessons. Errors: it cannot be read, or something in it is wrong.
[[nodiscard]] tl::expected<void, InputError> read_defaults();

/// What was read.
[[nodiscard]] const Defaults& defaults();

/// The folder of the lessons that the program has unless it is given another.
[[nodiscard]] std::filesystem::path lessons_folder();

/// The lesson that shows a point file that no lesson was named for: all volumes around it, side by side.
inline constexpr const char* kPointsLesson = "which-volume";

}  // namespace snug::desktop
