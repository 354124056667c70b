#include "lesson/text_place.hpp"

#include <algorithm>

namespace snug::lesson {

std::string_view text_of(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  const auto* value = node != nullptr ? node->as_string() : nullptr;
  return value != nullptr ? std::string_view(value->get()) : std::string_view();
}

FilePlace place_in_text(const toml::table& table, std::string_view key, std::size_t at) {
  const toml::node* node = table.get(key);
  const FilePlace begin = file_place(node != nullptr ? *node : table);
  const std::string_view text = text_of(table, key);
  if (at >= text.size()) return begin;
  // Counts lines from the end, because the parser drops the first line end of a text within three quotes.
  const auto last = static_cast<int>(node->source().end.line);
  const std::string_view rest = text.substr(at);
  const int line = last - static_cast<int>(std::count(rest.begin(), rest.end(), '\n'));
  const std::size_t line_end = at > 0 ? text.rfind('\n', at - 1) : std::string::npos;
  const int before = static_cast<int>(line_end == std::string::npos ? at : at - line_end - 1);  // on its line
  if (line < begin.line) return begin;  // line ends may be written as \n
  return {line, line == begin.line ? begin.column + 1 + before : 1 + before};
}

FilePlace place_in_text(const toml::table& table, std::string_view key, std::string_view words) {
  return place_in_text(table, key, text_of(table, key).find(words));
}

}  // namespace snug::lesson
