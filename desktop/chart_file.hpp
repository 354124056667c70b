// A chart of what `snug cost` wrote to a file.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "app/chart.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// path: costs, growth or a turn, as CSV or JSON. then: another of the same kind to lie over it; empty for
/// none. Errors: of reading either; a table that no chart is drawn of.
[[nodiscard]] tl::expected<app::Chart, InputError> read_chart(const std::string& path, const std::string& then);

}  // namespace snug::desktop
