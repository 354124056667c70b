// Reads a lesson's [view].
#pragma once

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// Reads [view], if the lesson has it.
[[nodiscard]] StageView read_view(TomlTable& lesson, Complaints& complaints);

}  // namespace snug::lesson
