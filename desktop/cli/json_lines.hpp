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

/// What --help says about volumes in JSON.
inline constexpr const char* kVolumesInJson =
    R"(  V                {"sphere":{"center":[x,y,z],"radius":r}}
                   {"aabb":{"min":[..],"max":[..]}}, {"aabb":{"min":[..],"widths":[..]}} or
                   {"aabb":{"center":[..],"half_extents":[..]}}
                   {"obb":{"center":[..],"axes":[[..],[..],[..]],"half_extents":[..]}}; axes are unit rows, right-handed
                   {"capsule":{"a":[..],"b":[..],"radius":r}}
                   {"lozenge":{"origin":[..],"edges":[[..],[..]],"radius":r}}; the edges are perpendicular
                   {"kdop":{"k":14,"min":[..],"max":[..]}}; k is 6, 14, 18 or 26, in 2-D 4, 6 or 8
                   {"hull":{"points":[[..],..]}}
                   In 2-D there are two numbers instead of three. )";

}  // namespace snug::desktop
