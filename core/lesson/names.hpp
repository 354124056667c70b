// Names that a lesson's file may use.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The names with commas between them, and before the last one a word: "bunny, teapot or dragon".
[[nodiscard]] std::string listed(const auto& names, std::string_view before_last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? before_last : ", ";
    text += names[i];
  }
  return text;
}
/// "bunny, teapot or dragon"
[[nodiscard]] std::string one_of(const auto& names) { return listed(names, " or "); }

/// Whether a link's target is the number of a step: digits, of which a run never has more.
[[nodiscard]] inline bool is_step_number(std::string_view target) {
  return !target.empty() && target.size() <= 6 && target.find_first_not_of("0123456789") == std::string_view::npos;
}

[[nodiscard]] bool is_among(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A name as typed names are compared: without blanks, in lower case, and with a hyphen for a minus sign.
[[nodiscard]] std::string plain_name(std::string_view name);

/// How many letters must be added, left out, changed or swapped with their neighbour to turn one word into the other.
/// Source: L. Boytsov, "Indexing methods for approximate dictionary searching", 2011 (optimal string alignment).
[[nodiscard]] int spelling_distance(std::string_view a, std::string_view b);

/// The name that another is probably a misspelling of, or the beginning of; empty where none is near enough.
[[nodiscard]] std::string_view nearest(const auto& names, std::string_view name) {
  std::string_view best;
  int least = static_cast<int>(name.size()) / 3 + 1;
  for (const std::string_view one : names)
    if (const int distance = spelling_distance(one, name); distance < least) best = one, least = distance;
  if (!best.empty() || name.size() < 3) return best;
  for (const std::string_view one : names)
    if (one.starts_with(name) && (best.empty() || one.size() < best.size())) best = one;
  return best;
}

/// "is none of ritter or welzl: wezl; did you mean welzl?"
[[nodiscard]] std::string none_of_text(std::string_view name, const auto& names) {
  const std::string_view meant = nearest(names, name);
  if (names.empty()) return "is not there: " + std::string(name);
  return "is none of " + one_of(names) + ": " + std::string(name) +
         (meant.empty() ? "" : "; did you mean " + std::string(meant) + "?");
}

/// Complains about a name that is not one of these. An empty name was reported when it was read.
void check_name(TomlTable& table, std::string_view key, std::string_view name, const auto& names) {
  if (!name.empty() && !is_among(names, name)) table.wrong(key, none_of_text(name, names));
}

/// Reads a list of names, each one of these and none twice.
[[nodiscard]] std::vector<std::string> read_names(TomlTable& table, std::string_view key, std::size_t least,
                                                  const auto& names) {
  std::vector<std::string> all = table.texts(key, least);
  for (const std::string& name : all) check_name(table, key, name.empty() ? " " : name, names);
  for (auto name = all.begin(); name != all.end(); ++name)
    if (std::find(all.begin(), name, *name) != name) table.wrong(key, "names " + *name + " twice");
  return all;
}

}  // namespace snug::lesson
