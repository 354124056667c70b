// Reads a result of `snug cost`, in either format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "measure/report.hpp"
#include "measure/trials.hpp"

namespace snug::desktop {

/// Reads the text of a table in CSV or JSON, which differ in the first character; a file is read once, for it may be a
/// pipe. Row: CostRow, GrowthRow, TurnRow or TrialRow. path: the file's, for errors: in CSV with the line, in JSON with
/// the field.
template <class Row>
[[nodiscard]] tl::expected<cost::Table<Row>, InputError> read_table(std::string_view text, const std::string& path);

/// The name of the table that a text begins with, such as "growth"; empty if it is not a table.
[[nodiscard]] std::string table_name(std::string_view text);

/// The text of a table of any kind as CSV. Errors: those of read_table.
[[nodiscard]] tl::expected<std::string, InputError> table_as_csv(std::string text, const std::string& path);

/// The error if an earlier result is on other points; none if the points are the same: in name, kind, number, dimension
/// and, if they are generated, seed. For growth, which has any number of points, only kinds are compared. path: that of
/// the earlier result.
[[nodiscard]] std::optional<InputError> of_other_points(const cost::Provenance& now, const cost::Provenance& then,
                                                        const std::string& path, bool any_number = false);

}  // namespace snug::desktop
