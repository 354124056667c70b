// A result of `snug cost` read back, in either of its forms.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "measure/report.hpp"

namespace snug::desktop {

/// Costs as CSV or JSON, told apart by the first character. Errors: of reading; in CSV with the line, in JSON with the
/// field.
[[nodiscard]] tl::expected<cost::Table<cost::CostRow>, InputError> read_costs(const std::string& path);

}  // namespace snug::desktop
