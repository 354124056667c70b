// For commands that read JSON Lines and answer each line with a line.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "desktop/cli/command.hpp"
#include "desktop/cli/json.hpp"

namespace snug::desktop {

/// Answers every line of a file ("-" is standard input) that is not empty. Stops at the first error, and reports its
/// line number. Errors: those of reading the file; a line that is not JSON or repeats a key; those of answer.
[[nodiscard]] CommandResult answer_lines(const std::string& file,
                                         const std::function<tl::expected<Json, std::string>(const Json&)>& answer);

}  // namespace snug::desktop
