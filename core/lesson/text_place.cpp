#include "lesson/text_place.hpp"

#include <algorithm>
#include <string>

namespace snug::lesson {

FilePlace place_in_text(const toml::table& table, std::string_view key, std::string_view words, std::string_view from) {
  const toml::node* node = table.get(key);
  const FilePlace begin = file_place(node != nullptr ? *node : table);
  const auto* value = node != nullptr ? node->as_string() : nullptr;
  if (value == nullptr) return begin;
  const std::string& text = value->get();
  const std::size_t beginning = from.empty() ? 0 : text.find(from);
  if (beginning == std::string::npos) return begin;
  const std::size_t found = text.find(words, beginning);
  if (found == std::string::npos && from.empty()) return begin;
  const std::size_t at = found == std::string::npos ? beginning : found;
  // From its end: of a text within three quotes the parser leaves out the first line end.
  const auto last = static_cast<int>(node->source().end.line);
  const auto rest = text.begin() + static_cast<std::ptrdiff_t>(at);
  const int line = last - static_cast<int>(std::count(rest, text.end(), '\n'));
  const std::size_t line_end = at > 0 ? text.rfind('\n', at - 1) : std::string::npos;
  const int before = static_cast<int>(line_end == std::string::npos ? at : at - line_end - 1);  // on its line
  if (line < begin.line) return begin;  // line ends may be written as \n
  return {line, line == begin.line ? begin.column + 1 + before : 1 + before};
}

}  // namespace snug::lesson
