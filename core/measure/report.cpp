#include "measure/report.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

#include "io/text.hpp"
#include "measure/trials.hpp"
#include "trace/json.hpp"

namespace snug::cost {
namespace {

constexpr std::string_view kFirstLine = "# snug table: ";

// ---- a row as names and values: so the code below is compiled once for all kinds of rows

using Value = std::variant<double*, int*, std::int64_t*, bool*, std::string*, std::optional<double>*,
                           std::optional<bool>*, std::optional<std::string>*>;
struct Field {
  std::string name;
  Value value;
  bool none = false;  // whether the timing has no repeats: nothing was timed

  /// "time_ns" of "time_ns.median"; empty of a name without a dot.
  [[nodiscard]] std::string level() const {
    const std::size_t dot = name.find('.');
    return dot == std::string::npos ? std::string() : name.substr(0, dot);
  }
};
using Fields = std::vector<Field>;

constexpr std::string_view kRepeats = ".repeats";

void add(Fields& fields, std::string_view name, Value value) { fields.push_back({std::string(name), value}); }

void mark_none(Fields& fields) {
  for (const Field& repeats : fields)
    if (repeats.name.ends_with(kRepeats) && **std::get_if<int*>(&repeats.value) == 0)
      for (Field& field : fields) field.none = field.none || field.level() == repeats.level();
}

template <class Row>
Fields fields_of(Row& row) {
  Fields fields;
  row.fields([&](std::string_view name, auto& value) { add(fields, name, &value); });
  mark_none(fields);
  return fields;
}

// ---- values as text: shared by both formats, except for missing values

/// The shortest text that reads back to the same bits; empty if the value is not finite.
std::string text_of(double value) { return std::isfinite(value) ? io::shortest_text(value) : std::string(); }
std::string text_of(std::int64_t value) { return std::to_string(value); }
std::string text_of(int value) { return std::to_string(value); }
std::string text_of(bool value) { return value ? "true" : "false"; }
template <class Held>
std::string text_of(const std::optional<Held>& value) {
  return value ? text_of(*value) : std::string();
}

std::string csv_value(const auto& value) { return text_of(value); }
std::string csv_value(double value) {
  if (std::isfinite(value)) return text_of(value);
  return std::isnan(value) ? "nan" : "inf";
}
std::string csv_value(const std::string& value);
std::string csv_value(const std::optional<std::string>& value) { return value ? csv_value(*value) : std::string(); }
std::string csv_value(const std::string& value) {
  if (value.find_first_of(",\"\r\n#") == std::string::npos) return value;
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"') text += '"';
    text += c == '\n' || c == '\r' ? ' ' : c;
  }
  return text + '"';
}

void put_json(JsonWriter& json, const std::string& value) { json.text(value); }
void put_json(JsonWriter& json, const std::optional<std::string>& value) {
  if (value) json.text(*value);
  else json.literal("null");
}
void put_json(JsonWriter& json, const auto& value) {
  const std::string text = text_of(value);
  json.literal(text.empty() ? "null" : text);
}

std::string csv_text(const Field& field) {
  if (field.none) return {};
  return std::visit([](const auto* value) { return csv_value(*value); }, field.value);
}
void add_csv_row(std::string& text, const Fields& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + csv_text(fields[i]);
  text += '\n';
}

/// Writes a row's fields as an object; consecutive names with the same part before a dot form an inner one, or null.
void put_object(JsonWriter& json, const Fields& fields) {
  json.open_object();
  std::string level, null;
  for (const Field& field : fields) {
    std::string own_level = field.level();
    if (field.none && own_level == null) continue;
    const std::string own_name = own_level.empty() ? field.name : field.name.substr(own_level.size() + 1);
    if (field.none) null = std::exchange(own_level, {});
    if (own_level != level) {
      if (!level.empty()) json.close_object();
      if (!own_level.empty()) {
        json.key(own_level);
        json.open_object();
      }
      level = own_level;
    }
    json.key(field.none ? null : own_name);
    if (field.none) json.literal("null");
    else std::visit([&](const auto* value) { put_json(json, *value); }, field.value);
  }
  if (!level.empty()) json.close_object();
  json.close_object();
}

// ---- reading them back

bool read_value(std::string_view text, double& value) {
  const auto number = io::parse_number(text);
  if (number) value = *number;
  return number.has_value();
}
bool read_value(std::string_view text, std::int64_t& value) {
  const auto number = io::parse_integer(text);
  if (number) value = *number;
  return number.has_value();
}
bool read_value(std::string_view text, int& value) {
  std::int64_t wide = 0;
  if (!read_value(text, wide) || wide != static_cast<int>(wide)) return false;
  value = static_cast<int>(wide);
  return true;
}
bool read_value(std::string_view text, bool& value) {
  value = text == "true";
  return value || text == "false";
}
bool read_value(std::string_view text, std::string& value) {
  value = text;
  return true;
}
template <class Value>
bool read_value(std::string_view text, std::optional<Value>& value) {
  value.reset();
  return text.empty() || read_value(text, value.emplace());
}

/// A line's fields; none if a quotation mark is not closed, or if something follows a closing one.
std::optional<std::vector<std::string>> fields_of_line(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false, closed = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (quoted && c == '"') {
      quoted = false;
      closed = true;
    } else if (!quoted && c == ',') {
      fields.emplace_back();
      closed = false;
    } else if (closed) {
      return std::nullopt;
    } else if (c == '"' && fields.back().empty() && !quoted) {
      quoted = true;
    } else {
      fields.back() += c;
    }
  }
  if (quoted) return std::nullopt;
  return fields;
}

tl::unexpected<InputError> at(std::string_view name, std::int64_t line, std::string what) {
  return tl::unexpected(InputError{std::move(what), std::string(name), InputError::Unit::kLine, line});
}

/// Sets the fields from texts by name; no name may be missing. A timing without repeats stays empty.
std::optional<std::string> set_fields(const Fields& fields,
                                      const std::function<const std::string*(std::string_view)>& text_by_name) {
  for (const Field& field : fields) {
    const std::string* text = text_by_name(field.name);
    if (text == nullptr && is_new_column(field.name)) continue;
    if (text == nullptr) return "there is no " + io::quoted(field.name);
    const std::string* repeats = field.none ? text_by_name(field.level().append(kRepeats)) : nullptr;
    if (text->empty() && repeats != nullptr && repeats->empty()) continue;
    if (!std::visit([&](auto* value) { return read_value(*text, *value); }, field.value))
      return io::quoted(*text) + " is not a value of " + io::quoted(field.name);
  }
  return std::nullopt;
}

/// The text with a name, from two lists of the same length; null if there is none.
const std::string* find_text(const std::vector<std::string>& names, const std::vector<std::string>& texts,
                             std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return &texts[i];
  return nullptr;
}

std::string csv_head(std::string_view table, const Fields& provenance, const Fields& columns) {
  std::string text = std::string(kFirstLine).append(table) + '\n';
  for (const Field& field : provenance) text += "# " + field.name + ": " + csv_text(field) + '\n';
  for (std::size_t i = 0; i < columns.size(); ++i) text += (i > 0 ? "," : "") + columns[i].name;
  return text + '\n';
}

using Wrong = std::optional<tl::unexpected<InputError>>;

/// columns: a row's fields, for their names. add_row: returns the fields of one more row.
Wrong read_lines(std::string_view text, std::string_view name, std::string_view table, const Fields& provenance,
                 const Fields& wanted, const std::function<Fields()>& add_row) {
  io::Lines lines(text);
  const std::string first = std::string(kFirstLine).append(table);
  if (!lines.next() || io::trim(lines.line()) != first)
    return at(name, 1, "the first line of such a table is " + io::quoted(first));

  std::vector<std::string> names, texts;  // those of the provenance, then of the columns
  bool more = lines.next();
  for (; more && lines.line().starts_with("# "); more = lines.next()) {
    const std::string_view line = lines.line().substr(2);
    const std::size_t colon = line.find(": ");
    const auto value = fields_of_line(colon == std::string_view::npos ? "" : line.substr(colon + 2));
    if (colon == std::string_view::npos || !value || value->size() != 1)
      return at(name, lines.number(), "is not a line of a provenance");
    names.emplace_back(line.substr(0, colon));
    texts.push_back(value->front());
  }
  if (const auto wrong = set_fields(provenance, [&](std::string_view key) { return find_text(names, texts, key); }))
    return at(name, lines.number(), *wrong);

  const auto columns = fields_of_line(more ? lines.line() : "");
  if (!columns) return at(name, lines.number(), "a quotation mark is not closed");
  for (const Field& field : wanted)
    if (find_text(*columns, *columns, field.name) == nullptr && !is_new_column(field.name))
      return at(name, lines.number(), "there is no " + io::quoted(field.name));
  while (lines.next_filled()) {
    const auto fields = fields_of_line(lines.line());
    if (!fields) return at(name, lines.number(), "a quotation mark is not closed");
    if (fields->size() != columns->size())
      return at(name, lines.number(),
                "there are " + io::counted(static_cast<std::int64_t>(fields->size()), "field") + ", and " +
                    io::counted(static_cast<std::int64_t>(columns->size()), "column"));
    if (const auto wrong =
            set_fields(add_row(), [&](std::string_view key) { return find_text(*columns, *fields, key); }))
      return at(name, lines.number(), *wrong);
  }
  return std::nullopt;
}

}  // namespace

// Fields can be written, so each row is copied before it is read.
template <class Row>
std::string csv_of(const Provenance& provenance, std::span<const Row> rows) {
  Provenance about = provenance;
  Row none;
  std::string text = csv_head(Row::kTable, fields_of(about), fields_of(none));
  for (Row row : rows) add_csv_row(text, fields_of(row));
  return text;
}

template <class Row>
std::string json_of(const Provenance& provenance, std::span<const Row> rows) {
  Provenance about = provenance;
  JsonWriter json;
  json.open_object();
  json.key("table");
  json.text(Row::kTable);
  json.key("provenance");
  put_object(json, fields_of(about));
  json.key("rows");
  json.open_list();
  for (Row row : rows) put_object(json, fields_of(row));
  json.close_list();
  json.close_object();
  return json.take() + '\n';
}

template <class Row>
tl::expected<Table<Row>, InputError> read_csv(std::string_view text, std::string_view name) {
  Table<Row> table;
  Row none;
  const auto wrong = read_lines(text, name, Row::kTable, fields_of(table.provenance), fields_of(none),
                                [&] { return fields_of(table.rows.emplace_back()); });
  if (wrong) return *wrong;
  return table;
}

#define SNUG_INSTANTIATE(Row)                                                                                          \
  template std::string csv_of(const Provenance&, std::span<const Row>);                                                \
  template std::string json_of(const Provenance&, std::span<const Row>);                                               \
  template tl::expected<Table<Row>, InputError> read_csv<Row>(std::string_view, std::string_view);
SNUG_INSTANTIATE(CostRow)
SNUG_INSTANTIATE(GrowthRow)
SNUG_INSTANTIATE(TurnRow)
SNUG_INSTANTIATE(WhichRow)
SNUG_INSTANTIATE(ClaimRow)
SNUG_INSTANTIATE(TrialRow)
#undef SNUG_INSTANTIATE

}  // namespace snug::cost
