// Writes tables as CSV and JSON, and reads CSV back, so that one result can be shown over another.
//
// CSV: the table's name and the provenance in lines that begin with "# ", the columns' names, and a line for each row.
// A missing value is an empty field; numbers read back to the same bits. JSON:
// {"table":"costs","provenance":{...},"rows":[...]}; a missing value is null, and so is the whole of "update_ns" if no
// update was timed.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

/// A column that files of earlier versions lack: it is then read as 0.
[[nodiscard]] constexpr bool is_new_column(std::string_view name) {
  return name == "operations.exact_decisions" || name.starts_with("scene_overlap_ns.");
}

template <class Row>
struct Table {
  Provenance provenance;
  std::vector<Row> rows;
};

/// Row: a type of rows.hpp.
template <class Row>
[[nodiscard]] std::string csv_of(const Provenance& provenance, std::span<const Row> rows);
/// The table as one line, with its line feed.
template <class Row>
[[nodiscard]] std::string json_of(const Provenance& provenance, std::span<const Row> rows);

/// Reads what csv_of wrote. Columns may be in another order; unknown ones are ignored. Errors, with the line: another
/// table, a missing column or line of the provenance, a row with more or fewer fields, a field with a wrong value, a
/// quotation mark that is not closed.
template <class Row>
[[nodiscard]] tl::expected<Table<Row>, InputError> read_csv(std::string_view text, std::string_view name);

}  // namespace snug::cost
