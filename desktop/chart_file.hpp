// Makes a chart from a file that `snug cost` wrote.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "app/chart.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// path: a table of costs, growth, a turn, or the trials of one claim, as CSV or JSON. then: another of the same kind,
/// not of trials, to show over it; empty for none. Errors: those of reading either; a table for which there is no
/// chart.
[[nodiscard]] tl::expected<app::Chart, InputError> read_chart(const std::string& path, const std::string& then);

}  // namespace snug::desktop
