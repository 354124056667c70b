#include "core/lesson/lesson_files.hpp"
#include "check/check_lesson.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <utility>

namespace snug::test {

const std::string& lessons_folder() {
  static const std::string folder = SNUG_SOURCE_DIR "/lessons/";
  return folder;
}

std::string lessons_file(const std::string& name) {
  std::ifstream file(lessons_folder() + name, std::ios::binary);
  REQUIRE_MESSAGE(file.good(), name);
  return {std::istreambuf_iterator<char>(file), {}};
}

lesson::Lesson lesson_of(const std::string& id) {
  auto lesson = check::checked_lesson(lessons_file(id + ".toml"), id + ".toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  return *std::move(lesson);
}

lesson::Session session_of(const std::string& id) {
  auto session = lesson::Session::open(lesson_of(id));
  REQUIRE_MESSAGE(session.has_value(), id);
  return *std::move(session);
}

}  // namespace snug::test
