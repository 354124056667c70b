#include "lesson/toml_file.hpp"

#include "lesson/lesson.hpp"

namespace snug::lesson {

std::optional<toml::table> parse_file(std::string_view text, std::string_view kind, Complaints& complaints) {
  if (text.size() > kMostLessonBytes) {
    complaints.add(1, "the file is too long: " + std::string(kind) + " has at most " +
                          std::to_string(kMostLessonBytes) + " bytes");
    return std::nullopt;
  }
  toml::parse_result parsed = toml::parse(text);
  if (parsed) return std::move(parsed).table();
  const toml::parse_error& error = parsed.error();
  complaints.add(file_place(error.source()), std::string(error.description()));
  return std::nullopt;
}

}  // namespace snug::lesson
