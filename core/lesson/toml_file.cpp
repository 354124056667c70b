#include "lesson/toml_file.hpp"

#include <algorithm>

#include "io/text.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {
namespace {

/// Each dot of a key nests one table in another, and nested tables are read and destroyed recursively: thousands
/// overflow the stack. Held by "a key of more dots than a file needs is refused before it is read".
constexpr int kMostDots = 64;

/// The place after a string that begins here. In one that stands between three quotes, lines may end.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool many_lines = text.substr(at, 3) == three;
  for (at += many_lines ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') ++at;
    else if (many_lines ? text.substr(at, 3) == three : text[at] == quote || text[at] == '\n') break;
  }
  return std::min(text.size(), at + (many_lines ? 3 : 1));
}

bool is_of_key(char letter) {
  const auto code = static_cast<unsigned char>(letter);
  return (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z') ||
         letter == '_' || letter == '-' || letter == ' ' || letter == '\t' || code >= 0x80;
}

/// The line of the first key with too many dots, counted from 1; none if there is no such key.
std::optional<int> line_of_deep_key(std::string_view text) {
  int line = 1, dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    std::size_t next = at + 1;
    if (letter == '"' || letter == '\'') next = after_string(text, at);
    else if (letter == '#') next = std::min(text.find('\n', at), text.size());
    else if (letter == '.') ++dots;
    else if (!is_of_key(letter)) dots = 0;
    if (dots > kMostDots) return line;
    const std::string_view passed = text.substr(at, next - at);
    line += static_cast<int>(std::count(passed.begin(), passed.end(), '\n'));
    at = next;
  }
  return std::nullopt;
}

}  // namespace

std::optional<toml::table> parse_file(std::string_view text, std::string_view kind, Complaints& complaints) {
  if (text.size() > kMostLessonBytes) {
    complaints.add(1, "the file is too long: " + std::string(kind) + " has at most " +
                          std::to_string(kMostLessonBytes) + " bytes");
    return std::nullopt;
  }
  if (io::is_utf16(text)) {
    complaints.add(1, io::kIsUtf16);
    return std::nullopt;
  }
  if (const auto line = line_of_deep_key(text)) {
    complaints.add(*line, "a key has more than " + std::to_string(kMostDots) + " dots");
    return std::nullopt;
  }
  toml::parse_result parsed = toml::parse(text);
  if (parsed) return std::move(parsed).table();
  const toml::parse_error& error = parsed.error();
  complaints.add(file_place(error.source()), std::string(error.description()));
  return std::nullopt;
}

}  // namespace snug::lesson
