// Names that a lesson's file may use.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// "bunny, teapot or dragon"
[[nodiscard]] std::string one_of(const auto& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

[[nodiscard]] bool is_among(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Complains about a name that is not one of these. An empty name was reported when it was read.
void check_name(TomlTable& table, std::string_view key, std::string_view name, const auto& names) {
  if (!name.empty() && !is_among(names, name))
    table.wrong(key, "is none of " + one_of(names) + ": " + std::string(name));
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
