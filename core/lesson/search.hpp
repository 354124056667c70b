// Finding a lesson or an exercise of the course by words: of its number, title, summary, chapter and headings, of the
// slides that it covers, its terms and its algorithms.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// What a lesson is found by, in small letters without accents and apostrophes. number: counted from 1. slides: those
/// that it covers.
[[nodiscard]] std::string search_text(const Lesson& lesson, int number, std::string_view chapter,
                                      std::span<const std::string> slides);

/// Whether each of the words that are asked for is among them, or begins within them.
[[nodiscard]] bool is_found(std::string_view search_text, std::string_view asked);

/// Whether anything is asked for at all.
[[nodiscard]] bool is_search(std::string_view asked);

/// How many of each were found.
struct Found {
  int lessons = 0, sheets = 0, exercises = 0;
};

/// "3 lessons", "1 lesson, 1 lab sheet, 2 exercises", or that none has those words.
[[nodiscard]] std::string found_text(const Found& found, std::string_view asked);

}  // namespace snug::lesson
