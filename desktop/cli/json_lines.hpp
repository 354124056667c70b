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

/// The same of a case, where one is named: line_of_case gives what a file would have.
[[nodiscard]] CommandResult answer_given(const std::string& file, const std::string& name,
                                         tl::expected<std::string, InputError> (*line_of_case)(const std::string&),
                                         const std::function<tl::expected<Json, std::string>(const Json&)>& answer);

}  // namespace snug::desktop
