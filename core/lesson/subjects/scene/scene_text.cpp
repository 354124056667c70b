#include "lesson/subjects/scene/scene_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "geometry/sort.hpp"
#include "lesson/subjects/scene/read_scene.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {
namespace {

using Keyed = std::pair<std::string_view, const toml::node*>;

/// The keys of a table in the order of its file.
std::vector<Keyed> keys_in_order(const toml::table& table) {
  std::vector<Keyed> keys;
  for (const auto& [key, node] : table) keys.emplace_back(key.str(), &node);
  const auto place = [](const Keyed& one) {
    const toml::source_position at = one.second->source().begin;
    return std::pair(at.line, at.column);
  };
  sort_stably(keys, [&](const Keyed& a, const Keyed& b) { return place(a) < place(b); });
  return keys;
}

bool is_tables(const toml::node& node) {
  const toml::array* array = node.as_array();
  return array != nullptr && !array->empty() && array->get(0)->is_table();
}

/// The shortest text that is read as the same number. TOML tells a float by its point or exponent.
std::string toml_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::array<char, 40> text{};
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    if (std::strtod(text.data(), nullptr) == value) break;
  }
  std::string number = text.data();
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

std::string in_toml_quotes(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += c == '\n' ? ' ' : c;
  }
  return all + '"';
}

std::string toml_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_toml_quotes(text->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) return toml_number(number->get());
  std::string all = "[";
  if (const auto* array = node.as_array())
    for (const toml::node& item : *array) all.append(all.size() > 1 ? ", " : "").append(toml_value(item));
  return all + "]";
}

/// A header, and the keys of its table that are no tables.
std::string table_text(std::string_view header, const toml::table& table) {
  std::string text(header);
  text += '\n';
  for (const auto& [key, node] : keys_in_order(table))
    if (!is_tables(*node) && key != "graph") text.append(key).append(" = ").append(toml_value(*node)).append("\n");
  return text;
}

std::string_view without_indent(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

bool sets_called(std::string_view line) {
  line = without_indent(line);
  constexpr std::string_view kKey = "called";
  return line.starts_with(kKey) && without_indent(line.substr(kKey.size())).starts_with('=');
}

std::vector<std::string> lines_in(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : text)
    if (c == '\n') lines.emplace_back();
    else lines.back() += c;
  return lines;
}

}  // namespace

std::string write_scene(const toml::table& scene) {
  std::string text = table_text("[scene]", scene);
  for (const auto& [key, node] : keys_in_order(scene)) {
    if (!is_tables(*node)) continue;
    const std::string header = "\n[[scene." + std::string(key) + "]]";
    for (const toml::node& one : *node->as_array())
      if (const toml::table* table = one.as_table()) text += table_text(header, *table);
  }
  return text;
}

std::string with_calls(std::string_view text, const std::vector<bool>& called) {
  std::vector<std::string> lines;
  std::size_t effect = 0, end = 0;  // end: after the last line with words of the effect at hand
  bool inside = false;
  const auto finish = [&] {
    if (inside && effect <= called.size() && !called[effect - 1])
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(end), "called = false");
    inside = false;
  };
  for (std::string& line : lines_in(text)) {
    const std::string_view words = without_indent(line);
    if (words.starts_with('[')) {
      finish();
      inside = words.starts_with("[[scene.effect]]");
      effect += inside ? 1 : 0;
    }
    if (inside && sets_called(words)) continue;
    lines.push_back(std::move(line));
    if (!without_indent(lines.back()).empty()) end = lines.size();
  }
  finish();
  std::string all;
  for (const std::string& line : lines) all.append(&line == lines.data() ? "" : "\n").append(line);
  return all;
}

SceneTyped read_typed(std::string_view text) {
  Complaints complaints("");
  SceneTyped typed;
  const auto toml = parse_file(text, "a scene", complaints);
  if (toml) {
    TomlTable root(*toml, "the file", complaints);
    const toml::table* scene = root.table("scene");
    if (scene == nullptr) root.lack("scene", "the file lacks [scene]");
    else typed.set = read_scene_table(*scene, false, true, complaints);
    root.refuse_others();
  }
  typed.mistakes = complaints.mistakes();
  if (!typed.mistakes.empty()) typed.set.reset();
  if (typed.set) typed.set->graph = typed.set->typed = true, typed.set->text = text;
  return typed;
}

}  // namespace snug::lesson
