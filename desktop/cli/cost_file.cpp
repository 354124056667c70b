#include "desktop/cli/cost_file.hpp"

#include <limits>

#include "desktop/cli/json.hpp"

namespace snug::desktop {
namespace {

/// Reads a number. JSON has no infinity, so null stands for it.
bool read(const Json& json, double& value) {
  value = json.is_number() ? json.get<double>() : std::numeric_limits<double>::infinity();
  return json.is_number() || json.is_null();
}
bool read(const Json& json, std::int64_t& value) {
  return json.is_number_integer() && (value = json.get<std::int64_t>(), true);
}
bool read(const Json& json, int& value) {
  std::int64_t wide = 0;
  if (!read(json, wide) || wide != static_cast<int>(wide)) return false;
  value = static_cast<int>(wide);
  return true;
}
bool read(const Json& json, bool& value) { return json.is_boolean() && (value = json.get<bool>(), true); }
bool read(const Json& json, std::string& value) { return json.is_string() && (value = json.get<std::string>(), true); }
template <class Value>
bool read(const Json& json, std::optional<Value>& value) {
  value.reset();
  return json.is_null() || read(json, value.emplace());
}

/// The value at a path such as "time_ns.median"; null if there is none.
const Json* find(const Json& json, std::string_view name) {
  const std::size_t dot = name.find('.');
  const Json* const found = value_at(json, name.substr(0, dot));
  return found == nullptr || dot == std::string_view::npos ? found : find(*found, name.substr(dot + 1));
}

/// Whether the field is within an object that is null, because nothing was timed.
bool is_none(const Json& json, std::string_view name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos || !name.substr(0, dot).ends_with("_ns")) return false;
  const Json* const level = find(json, name.substr(0, dot));
  return level != nullptr && level->is_null();
}

/// Reads a row. Returns what is wrong, or an empty text.
template <class Row>
std::string set_fields(Row& row, const Json& json, const std::string& where) {
  std::string wrong;
  row.fields([&](std::string_view name, auto& value) {
    if (!wrong.empty() || is_none(json, name)) return;
    const Json* const found = find(json, name);
    if (found == nullptr && cost::is_new_column(name)) return;
    if (found == nullptr) wrong = where + std::string(name) + " is missing";
    else if (!read(*found, value))
      wrong = where + std::string(name) + " is " + found->dump(-1, ' ', false, Json::error_handler_t::replace);
  });
  return wrong;
}

/// Reads the table. Returns what is wrong, or an empty text.
template <class Row>
std::string set_table(cost::Table<Row>& table, const Json& json) {
  const Json* const name = find(json, "table");
  if (name == nullptr || *name != Row::kTable) return "is not a table of " + std::string(Row::kTable);
  const Json *const provenance = find(json, "provenance"), *const rows = find(json, "rows");
  if (provenance == nullptr || rows == nullptr || !rows->is_array()) return "has no provenance, or no rows";
  std::string wrong = set_fields(table.provenance, *provenance, "provenance.");
  for (std::size_t i = 0; wrong.empty() && i < rows->size(); ++i)
    wrong = set_fields(table.rows.emplace_back(), (*rows)[i], "rows[" + std::to_string(i) + "].");
  return wrong;
}

}  // namespace

template <class Row>
tl::expected<cost::Table<Row>, InputError> read_table(std::string_view text, const std::string& path) {
  if (text.empty() || text.front() != '{') return cost::read_csv<Row>(text, path);
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return tl::unexpected(InputError{.what = "is not JSON", .file = path});
  cost::Table<Row> table;
  if (const std::string wrong = set_table(table, json); !wrong.empty())
    return tl::unexpected(InputError{.what = wrong, .file = path});
  return table;
}
template tl::expected<cost::Table<cost::CostRow>, InputError> read_table(std::string_view, const std::string&);
template tl::expected<cost::Table<cost::GrowthRow>, InputError> read_table(std::string_view, const std::string&);
template tl::expected<cost::Table<cost::TurnRow>, InputError> read_table(std::string_view, const std::string&);
template tl::expected<cost::Table<cost::TrialRow>, InputError> read_table(std::string_view, const std::string&);

std::optional<InputError> of_other_points(const cost::Provenance& now, const cost::Provenance& then,
                                          const std::string& path, bool any_number) {
  const auto name = [&](const cost::Provenance& p) {
    const std::string own = p.points.substr(p.points.find_last_of('/') + 1);
    return any_number ? own.substr(0, own.find(':')) : own;
  };
  const auto words = [](const cost::Provenance& p) {
    return p.points + " (" + std::to_string(p.dim) + "-D, seed " + std::to_string(p.seed) + ")";
  };
  const bool generated = now.points.find(':') != std::string::npos;
  if (name(now) == name(then) && now.dim == then.dim && (!generated || now.seed == then.seed)) return std::nullopt;
  return InputError{.what = "was measured on " + words(then) + ", and this on " + words(now) +
                            ": only results on the same points can be compared",
                    .file = path};
}

namespace {

template <class Row>
tl::expected<std::string, InputError> as_csv(std::string_view text, const std::string& path) {
  const auto table = read_table<Row>(text, path);
  if (!table) return tl::unexpected(table.error());
  return cost::csv_of(table->provenance, std::span<const Row>(table->rows));
}

}  // namespace

tl::expected<std::string, InputError> table_as_csv(std::string text, const std::string& path) {
  if (text.empty() || text.front() != '{') return text;
  const std::string name = table_name(text);
  if (name == cost::GrowthRow::kTable) return as_csv<cost::GrowthRow>(text, path);
  if (name == cost::TurnRow::kTable) return as_csv<cost::TurnRow>(text, path);
  return as_csv<cost::CostRow>(text, path);
}

std::string table_name(std::string_view text) {
  constexpr std::string_view kCsv = "# snug table: ", kJson = "{\"table\":\"";
  for (const std::string_view first : {kCsv, kJson})
    if (text.starts_with(first))
      return std::string(text.substr(first.size(), text.find_first_of("\r\n\"", first.size()) - first.size()));
  return {};
}

}  // namespace snug::desktop
