#include "course_lessons.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "places.hpp"

namespace snug::app {

lesson::Lesson course_lesson(const std::string& id, bool asks) {
  std::ifstream file(lessons_folder() + id + ".toml", std::ios::binary);
  REQUIRE_MESSAGE(file.good(), id);
  const std::string toml{std::istreambuf_iterator<char>(file), {}};
  auto lesson = lesson::read_lesson(toml, id + ".toml", lesson::Checked::kAsWritten);
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  if (!asks) lesson->questions.clear();
  return *std::move(lesson);
}

}  // namespace snug::app
