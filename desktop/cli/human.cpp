#include "desktop/cli/human.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <vector>

#include "desktop/cli/cost_text.hpp"
#include "desktop/cli/json.hpp"

namespace snug::desktop {
namespace {

struct HumanCell {
  std::string text;
  bool right = false;  // a number
};
using Values = std::vector<std::pair<std::string, HumanCell>>;

constexpr std::size_t kFewest = 8;     // letters that a cut text keeps
constexpr std::size_t kMostItems = 6;  // of a list that is written out

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

/// The values with their names, those of nested objects as "time_ns.median".
void add_values(Values& values, const Json& object, const std::string& before) {
  for (const auto& [key, value] : object.items())
    if (value.is_object() && !value.empty()) add_values(values, value, before + key + '.');
    else values.emplace_back(before + key, cell_of(before + key, value));
}

/// How many letters a text in UTF-8 has.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string cut(const std::string& text, std::size_t width) {
  if (letters(text) <= width) return text;
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end)
    if ((static_cast<unsigned char>(text[end]) & 0xc0) != 0x80 && ++seen == width) break;
  return text.substr(0, end) + "…";
}

std::string padded_cell(const HumanCell& cell, std::size_t width) {
  const std::string text = cut(cell.text, width);
  const std::string pad(width - std::min(width, letters(text)), ' ');
  return cell.right ? pad + text : text + pad;
}

std::string without_end_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string list_text(const Values& values, bool color) {
  std::size_t widest = 0;
  for (const auto& [key, cell] : values) widest = std::max(widest, key.size());
  std::string text;
  for (const auto& [key, cell] : values)
    text += (color ? "\x1b[1m" : "") + key + (color ? "\x1b[0m" : "") + std::string(widest - key.size() + 2, ' ') +
            cell.text + '\n';
  return text;
}

std::string table_text(const std::vector<Values>& rows, int width, bool color) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    widths.push_back(rows.front()[i].first.size());
    for (const Values& row : rows) widths[i] = std::max(widths[i], letters(row[i].second.text));
  }
  const auto all = [&] { return std::accumulate(widths.begin(), widths.end(), 2 * (widths.size() - 1)); };
  while (all() > static_cast<std::size_t>(width)) {
    // The first column names the row.
    const auto widest = std::max_element(widths.begin() + (widths.size() > 1 ? 1 : 0), widths.end());
    if (*widest <= kFewest) break;  // too many columns: the terminal breaks the lines
    --*widest;
  }
  std::string head, text;
  for (std::size_t i = 0; i < widths.size(); ++i)
    head += padded_cell({rows.front()[i].first, rows.front()[i].second.right}, widths[i]) + "  ";
  text = (color ? "\x1b[1m" : "") + without_end_blanks(head);
  if (color) text.insert(text.size() - 1, "\x1b[0m");
  for (const Values& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) line += padded_cell(row[i].second, widths[i]) + "  ";
    text += without_end_blanks(line);
  }
  return text;
}

bool same_names(const Values& a, const Values& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& one, const auto& other) { return one.first == other.first; });
}

}  // namespace

std::string human_text(const std::string& lines, int width, bool color) {
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
  if (rows.size() == 1) return list_text(rows.front(), color);
  // Rows with other names are other things: each kind has a table.
  std::string text;
  for (std::size_t from = 0; from < rows.size();) {
    std::size_t to = from;
    while (to < rows.size() && same_names(rows[from], rows[to])) ++to;
    if (from > 0) text += '\n';
    const std::vector<Values> alike(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                    rows.begin() + static_cast<std::ptrdiff_t>(to));
    text += alike.size() == 1 ? list_text(alike.front(), color) : table_text(alike, width, color);
    from = to;
  }
  return text;
}

}  // namespace snug::desktop
