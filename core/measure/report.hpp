// Tables as CSV and JSON, and CSV read back, so that one result can lie over another.
//
// CSV: the table's name and the provenance in lines that begin with "# ", the columns' names, a line a row. What there
// is none of is an empty field; numbers read back to the same bits. JSON:
// {"table":"costs","provenance":{...},"rows":[...]}; what there is none of is null, and of what was not timed that is
// all of "update_ns".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "measure/rows.hpp"

namespace snug::cost {

/// A column that files of earlier versions do not have: read from them, it stays 0.
inline constexpr std::string_view kNewColumn = "operations.exact_decisions";

template <class Row>
struct Table {
  Provenance provenance;
  std::vector<Row> rows;
};

/// Row: one of rows.hpp.
template <class Row>
[[nodiscard]] std::string csv_of(const Provenance& provenance, std::span<const Row> rows);
/// One line, with its line feed.
template <class Row>
[[nodiscard]] std::string json_of(const Provenance& provenance, std::span<const Row> rows);

/// What csv_of wrote. Columns may stand in another order; unknown ones are passed over. Errors, with the line: another
/// table, a column or a line of the provenance that is missing, a row with more or fewer fields, a field that is no
/// such value, a quotation mark that is not closed.
template <class Row>
[[nodiscard]] tl::expected<Table<Row>, InputError> read_csv(std::string_view text, std::string_view name);

}  // namespace snug::cost
