#include "desktop/cli/data_folder.hpp"

#include <initializer_list>

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

fs::path program_folder() {
  std::error_code error;
  const fs::path program = fs::canonical("/proc/self/exe", error);
  return error ? fs::current_path(error) : program.parent_path();
}

/// The first of these folders, seen from the program's, that has an entry of that name; else the program's own.
fs::path folder_with(const char* name, std::initializer_list<const char*> folders) {
  const fs::path program = program_folder();
  std::error_code error;
  for (const char* folder : folders)
    if (fs::path there = (program / folder).lexically_normal(); fs::exists(there / name, error)) return there;
  return program;
}

}  // namespace

fs::path data_folder() { return folder_with("lessons", {"", SNUG_COMMAND_TO_DATA, SNUG_WINDOW_TO_DATA}); }

fs::path window_program() { return folder_with("snug-window", {"", SNUG_COMMAND_TO_WINDOW}) / "snug-window"; }

}  // namespace snug::desktop
