#include "lesson/text_line.hpp"

#include <algorithm>
#include <string>

namespace snug::lesson {

int line_in_text(const toml::table& table, std::string_view key, std::string_view words, std::string_view from) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::max(static_cast<int>(table.source().begin.line), 1);
  const int first = static_cast<int>(node->source().begin.line), last = static_cast<int>(node->source().end.line);
  const auto* value = node->as_string();
  if (value == nullptr) return first;
  const std::string& text = value->get();
  const std::size_t beginning = from.empty() ? 0 : text.find(from);
  if (beginning == std::string::npos) return first;
  const std::size_t found = text.find(words, beginning);
  if (found == std::string::npos && from.empty()) return first;
  const auto at = text.begin() + static_cast<std::ptrdiff_t>(found == std::string::npos ? beginning : found);
  // Counts from the text's end, because the parser drops the first line end of a text in triple quotes.
  const int line = last - static_cast<int>(std::count(at, text.end(), '\n'));
  return std::clamp(line, first, last);  // clamped, because line ends may be written as \n
}

}  // namespace snug::lesson
