// A table that was measured for a lab sheet on another day, in words: what the window shows of it again.
#pragma once

#include <string>

#include "app/cover.hpp"
#include "desktop/cli/sheet_files.hpp"

namespace snug::desktop {

/// "Measured on 2026-11-28, on teapot, by AMD EPYC, native, GNU 12.2.0, Release. Measure again to replace it."
[[nodiscard]] std::string measured_says(const MeasuredTable& measured);

/// Its figures, each time with its spread; of any kind of table that a sheet can ask for. What a file of another
/// version lacks is a dash.
[[nodiscard]] app::WordTable measured_words(const MeasuredTable& measured);

}  // namespace snug::desktop
