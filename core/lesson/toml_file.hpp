// Parses a file of the course.
#pragma once

#include <optional>
#include <string_view>

#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The tables of a file; none, with a complaint, if it is too long or
/// is not TOML, or a key has too many dots. kind: "a lesson", for the complaint.
[[nodiscard]] std::optional<toml::table> parse_file(std::string_view text, std::string_view kind,
                                                    Complaints& complaints);

}  // namespace snug::lesson
