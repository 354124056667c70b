#include "course_lessons.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "places.hpp"

namespace snug::app {
namespace {

std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE_MESSAGE(file.good(), path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

lesson::Lesson course_lesson(const std::string& id, bool asks) {
  const std::string toml = bytes_of_file(lessons_folder() + id + ".toml");
  auto lesson = lesson::read_lesson(toml, id + ".toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  if (!asks) lesson->questions.clear();
  return *std::move(lesson);
}

std::vector<lesson::Lesson> all_lessons(bool asks) {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(lessons_folder()))
    if (entry.path().extension() == ".toml" && entry.path().filename() != "course.toml")
      ids.push_back(entry.path().stem().string());
  std::sort(ids.begin(), ids.end());  // a folder has no order
  std::vector<lesson::Lesson> lessons;
  for (const std::string& id : ids) lessons.push_back(course_lesson(id, asks));
  return lessons;
}

std::optional<io::PointFile> mesh_of(const std::string& mesh) {
  if (mesh.empty()) return std::nullopt;
  const std::string name = mesh + ".ply";
  auto read = io::read_points(bytes_of_file(assets_folder() + "meshes/" + name), name);
  REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().message()));
  return *std::move(read);
}

}  // namespace snug::app
