// Reads and checks a lesson's [view].
#pragma once

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// Reads [view], if the lesson has it.
[[nodiscard]] StageView read_view(TomlTable& lesson, Complaints& complaints);
/// Checks what depends on the subject: its handles, its dimension, whether it has points or a gap.
void check_view(const StageView& view, const toml::table& lesson, const Subject& own, Complaints& complaints);

}  // namespace snug::lesson
