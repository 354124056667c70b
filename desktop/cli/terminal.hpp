// What standard output is, and how people want to read there.
#pragma once

#include <string>

namespace snug::desktop {

/// Whether people read standard output, and no program.
[[nodiscard]] bool is_terminal();
/// Whether they may have colour: it is a terminal that has it, and NO_COLOR is not set.
[[nodiscard]] bool has_color();
/// How many letters wide it is; 100 where it does not say.
[[nodiscard]] int terminal_width();

}  // namespace snug::desktop
