#include "desktop/cli/human.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "desktop/cli/cost_text.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/words.hpp"

namespace snug::desktop {
namespace {

struct HumanCell {
  std::string text;
  bool right = false;  // a number
};
using Values = std::vector<std::pair<std::string, Json>>;

constexpr std::size_t kReadable = 30;  // letters that a cut text keeps, while a column can be left out instead
constexpr std::size_t kFewest = 8;     // and where none can
constexpr std::size_t kMostItems = 6;  // of a list in a table, and rows of a matrix

/// Columns of lists that are left out where there is no room, the first of these first: a star stands for any text.
constexpr std::array<std::string_view, 26> kLeftOut{
    "*_ns.repeats", "*_ns.min", "file",    "summary",   "source",    "says",   "algorithms", "sets",        "tasks",
    "lecture",      "group",    "chapter", "task",      "questions", "levels", "kind",       "lesson",      "naive",
    "sphere.*",     "aabb.*",   "obb.*",   "capsule.*", "lozenge.*", "kdop.*", "hull.*",     "conservative"};
constexpr std::string_view kCounts = "operations.";

bool is_like(std::string_view key, std::string_view pattern) {
  if (pattern.starts_with('*')) return key.ends_with(pattern.substr(1));
  if (pattern.ends_with('*')) return key.starts_with(pattern.substr(0, pattern.size() - 1));
  return key == pattern;
}

/// Names of figures in plain words.
constexpr std::array<std::array<std::string_view, 2>, 5> kPlain{{{"time_ns.median", "median time"},
                                                                 {"time_ns.min", "shortest time"},
                                                                 {"time_ns.repeats", "runs timed"},
                                                                 {"scene_ns.median", "in a scene"},
                                                                 {"gjk_ns.median", "by GJK"}}};

std::string shown_name(const std::string& key) {
  for (const auto& [name, plain] : kPlain)
    if (key == name) return std::string(plain);
  return key;
}

/// The name above a column, which has little room.
std::string head_of(const std::string& key) {
  return key.starts_with(kCounts) ? key.substr(kCounts.size()) : shown_name(key);
}

std::string number_words(const std::string& key, const Json& value) {
  if (key.find("_ns") != std::string::npos && key.find("spread") == std::string::npos &&
      key.find("repeats") == std::string::npos && key.find("batch") == std::string::npos)
    return time_text(value.get<double>());
  if (value.is_number_integer()) return value.dump() + (key == "bytes" ? " B" : "");
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value.get<double>());
  return text.data();
}

HumanCell cell_of(const std::string& key, const Json& value) {
  if (value.is_number()) return {number_words(key, value), true};
  if (value.is_boolean()) return {value.get<bool>() ? "yes" : "no", false};
  if (value.is_null()) return {"-", false};
  if (value.is_string()) return {value.get<std::string>(), false};
  if (value.is_array()) {
    std::string list;
    for (std::size_t i = 0; i < std::min(value.size(), kMostItems); ++i)
      list += (i > 0 ? ", " : "") + (value[i].is_structured() ? std::string("…") : cell_of(key, value[i]).text);
    return {list + (value.size() > kMostItems ? ", … (" + std::to_string(value.size()) + ")" : ""), false};
  }
  return {value.dump(), false};
}

/// The values with their names, those of nested objects as "certificate.contains".
void add_values(Values& values, const Json& object, const std::string& before) {
  for (const auto& [key, value] : object.items())
    if (value.is_object() && !value.empty()) add_values(values, value, before + key + '.');
    else values.emplace_back(before + key, value);
}

std::string cut(const std::string& text, std::size_t width) {
  if (letters_of(text) <= width) return text;
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end)
    if ((static_cast<unsigned char>(text[end]) & 0xc0) != 0x80 && ++seen == width) break;
  return text.substr(0, end) + "…";
}

std::string padded_cell(const HumanCell& cell, std::size_t width) {
  return padded(cut(cell.text, width), width, cell.right);
}

std::string without_end_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

/// As much of a list as has room, with how long it is where that is not all.
std::string list_in(const std::string& key, const Json& list, std::size_t room) {
  const std::string more = ", … (" + std::to_string(list.size()) + ')';
  std::string text, fits;  // fits: with room for the rest as well
  for (const Json& item : list) {
    text += (text.empty() ? "" : ", ") + (item.is_structured() ? std::string("…") : cell_of(key, item).text);
    if (letters_of(text) > room) return (fits.empty() ? text : fits) + more;
    if (letters_of(text + more) <= room) fits = text;
  }
  return text;
}

/// A value in lines of some width. A list of lists has a line for each.
std::vector<std::string> lines_of(const std::string& key, const Json& value, std::size_t room) {
  if (!value.is_array()) return {cell_of(key, value).text};
  const bool is_matrix = std::all_of(value.begin(), value.end(), [](const Json& row) { return row.is_array(); });
  if (!is_matrix || value.empty()) return {list_in(key, value, room)};
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(value.size(), kMostItems); ++i) lines.push_back(list_in(key, value[i], room));
  if (value.size() > kMostItems) lines.push_back("… (" + std::to_string(value.size()) + ')');
  return lines;
}

std::string list_text(const Values& values, std::size_t width, bool color) {
  std::size_t widest = 0;
  for (const auto& [key, value] : values) widest = std::max(widest, letters_of(shown_name(key)));
  std::string text;
  for (const auto& [key, value] : values) {
    std::string name = padded(shown_name(key), widest);
    if (color) name = "\x1b[1m" + name + "\x1b[0m";
    for (const std::string& line : lines_of(key, value, width - std::min(width, widest + 2))) {
      text += name + "  " + line + '\n';
      name.assign(widest, ' ');
    }
  }
  return text;
}

struct HumanColumn {
  std::string key;
  std::vector<HumanCell> cells;  // the name is the first
  bool can_be_cut = false;
  std::size_t widest = 0, width = 0;
};

std::vector<HumanColumn> columns_of(const std::vector<Values>& rows) {
  std::vector<HumanColumn> columns;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const std::string& key = rows.front()[i].first;
    HumanColumn column{key, {{head_of(key)}}};
    for (const Values& row : rows) {
      column.cells.push_back(cell_of(key, row[i].second));
      // What has no blanks is an id, a number or a path: it is of use as a whole. The first column names the row.
      const HumanCell& cell = column.cells.back();
      if (i > 0 && !cell.right && cell.text.find(' ') != std::string::npos) column.can_be_cut = true;
    }
    column.cells.front().right = column.cells[1].right;
    for (const HumanCell& cell : column.cells) column.widest = std::max(column.widest, letters_of(cell.text));
    columns.push_back(std::move(column));
  }
  return columns;
}

/// Cuts the widest texts, down to so many letters. Returns whether all has room then.
bool cut_to(std::vector<HumanColumn>& columns, std::size_t width, std::size_t fewest) {
  std::size_t all = 2 * (columns.size() - 1);
  for (HumanColumn& column : columns) all += column.width = column.widest;
  for (; all > width; --all) {
    HumanColumn* cut = nullptr;
    for (HumanColumn& column : columns)
      if (column.can_be_cut && column.width > fewest && (cut == nullptr || column.width > cut->width)) cut = &column;
    if (cut == nullptr) return false;
    --cut->width;
  }
  return true;
}

/// Makes the columns fit: cuts texts, and leaves out columns that would leave others too little.
void fit_in(std::vector<HumanColumn>& columns, std::size_t width) {
  const auto leave_out = [&](auto&& which) {
    const std::string first = columns.front().key;
    std::erase_if(columns, [&](const HumanColumn& column) { return column.key != first && which(column); });
  };
  const auto is_zero = [](const HumanColumn& column) {
    return column.key.starts_with(kCounts) && std::all_of(column.cells.begin() + 1, column.cells.end(),
                                                          [](const HumanCell& cell) { return cell.text == "0"; });
  };
  if (cut_to(columns, width, kReadable)) return;
  leave_out(is_zero);
  for (const std::string_view pattern : kLeftOut) {
    if (cut_to(columns, width, kReadable)) return;
    leave_out([&](const HumanColumn& column) { return is_like(column.key, pattern); });
  }
  while (!cut_to(columns, width, kFewest) && columns.back().key.starts_with(kCounts)) columns.pop_back();
}

std::string table_text(const std::vector<Values>& rows, std::size_t width, bool color) {
  std::vector<HumanColumn> columns = columns_of(rows);
  const std::size_t all = columns.size();
  fit_in(columns, width);
  std::string text;
  for (std::size_t row = 0; row <= rows.size(); ++row) {
    std::string line;
    for (const HumanColumn& column : columns) line += padded_cell(column.cells[row], column.width) + "  ";
    line = without_end_blanks(line);
    if (row == 0 && color) line = "\x1b[1m" + line.insert(line.size() - 1, "\x1b[0m");
    text += line;
  }
  const std::size_t out = all - columns.size();
  if (out > 0)
    text += std::to_string(out) + (out == 1 ? " column has" : " columns have") + " no room here; --json has all.\n";
  return text;
}

bool same_names(const Values& a, const Values& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& one, const auto& other) { return one.first == other.first; });
}

}  // namespace

std::string human_text(const std::string& lines, int width, bool color) {
  const auto room = static_cast<std::size_t>(width);
  std::vector<Values> rows;
  for (std::size_t from = 0; from < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', from), lines.size());
    const Json json = Json::parse(lines.begin() + static_cast<std::ptrdiff_t>(from),
                                  lines.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    if (!json.is_object()) return lines;
    add_values(rows.emplace_back(), json, "");
    from = end + 1;
  }
  if (rows.empty()) return lines;
  if (rows.size() == 1) return list_text(rows.front(), room, color);
  // Rows with other names are other things: each kind has a table.
  std::string text;
  for (std::size_t from = 0; from < rows.size();) {
    std::size_t to = from;
    while (to < rows.size() && same_names(rows[from], rows[to])) ++to;
    if (from > 0) text += '\n';
    const std::vector<Values> alike(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                    rows.begin() + static_cast<std::ptrdiff_t>(to));
    text += alike.size() == 1 ? list_text(alike.front(), room, color) : table_text(alike, room, color);
    from = to;
  }
  return text;
}

}  // namespace snug::desktop
