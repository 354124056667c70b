// Reads demos from the disk.
#pragma once

#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/lesson_files.hpp"
#include "lesson/demo.hpp"

namespace snug::desktop {

struct DemoFile {
  std::string path, text;
  lesson::Demo demo;
};

/// The demos of a lessons folder ("" is the program's own), by id. Errors: those of the folder.
[[nodiscard]] tl::expected<std::vector<std::string>, InputError> demo_paths(const std::string& folder);
/// The demo with an id, or of the file that a path leads to. Errors: all mistakes of its file; no such demo.
[[nodiscard]] tl::expected<std::shared_ptr<const DemoFile>, std::vector<InputError>>
find_demo(const std::string& folder, const std::string& id);

/// What is wrong with a key of a state, with file, line and column.
[[nodiscard]] InputError at_key(const DemoFile& file, const lesson::DemoState& state, std::string_view key,
                                const InputError& error);

}  // namespace snug::desktop
