// A result of `snug cost` read back, in either of its forms.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "measure/report.hpp"

namespace snug::desktop {

/// A table as CSV or JSON, told apart by the first character. Row: CostRow, GrowthRow or TurnRow. Errors: of reading;
/// in CSV with the line, in JSON with the field.
template <class Row>
[[nodiscard]] tl::expected<cost::Table<Row>, InputError> read_table(const std::string& path);

/// "growth" of a text that begins as such a table; empty where it begins as none.
[[nodiscard]] std::string table_name(std::string_view text);

/// What is wrong with laying an earlier result over one of other points; nothing where they are the same, by name, kind
/// and number, dimension and, where they are generated, seed. Of growth, which has points in any number, kinds alone
/// are compared. path: of the earlier result.
[[nodiscard]] std::optional<InputError> of_other_points(const cost::Provenance& now, const cost::Provenance& then,
                                                        const std::string& path, bool any_number = false);

}  // namespace snug::desktop
