// For commands that read JSON Lines and answer each line with a line.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "desktop/cli/command.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/volume_json.hpp"

namespace snug::desktop {

/// Answers every line of a file ("-" is standard input) that is not empty; of a case, where one is named: line_of_case
/// gives what a file would have. Stops at the first error, and reports its line number. rough: the axes that answer
/// finds rough, of which a warning tells. Errors: those of reading the file; a line that is not JSON or repeats a key;
/// those of answer.
[[nodiscard]] CommandResult answer_given(const std::string& file, const std::string& name,
                                         tl::expected<std::string, InputError> (*line_of_case)(const std::string&),
                                         const std::function<tl::expected<Json, std::string>(const Json&)>& answer,
                                         RoughAxes& rough);

}  // namespace snug::desktop
