#include "desktop/cli/lesson_files.hpp"

#include <algorithm>

#include "desktop/cli/files.hpp"
#include "lesson/subjects.hpp"
#include "lesson/trace_hash.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

fs::path folder_or_own(const std::string& folder) {
  return folder.empty() ? program_folder() / "lessons" : fs::path(folder);
}

tl::expected<std::vector<std::string>, InputError> toml_files(const fs::path& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  if (error)
    return tl::unexpected(
        InputError{.what = "lessons cannot be read from there: " + error.message(), .file = folder.string()});
  std::sort(paths.begin(), paths.end());  // so that of several errors it is always the same that is told
  return paths;
}

/// Nothing where the lesson has no mesh.
tl::expected<std::optional<io::PointFile>, InputError> mesh_of(const lesson::Lesson& lesson) {
  if (lesson.points.mesh.empty()) return std::nullopt;
  const fs::path path = program_folder() / "assets" / "meshes" / (lesson.points.mesh + ".ply");
  return read_point_file(path.string()).map([](io::PointFile&& mesh) { return std::optional(std::move(mesh)); });
}

}  // namespace

tl::expected<LessonFile, InputError> read_lesson_file(const std::string& path, lesson::Checked checked) {
  return read_start(path, lesson::kMostLessonBytes)
      .and_then([&](const std::string& text) { return lesson::read_lesson(text, path, checked); })
      .map([&](lesson::Lesson&& lesson) {
        return LessonFile{path, std::move(lesson)};
      });
}

tl::expected<std::vector<LessonFile>, InputError> read_lessons(const std::string& folder) {
  const auto paths = toml_files(folder_or_own(folder));
  if (!paths) return tl::unexpected(paths.error());
  std::vector<LessonFile> lessons;
  for (const std::string& path : *paths) {
    auto lesson = read_lesson_file(path);
    if (!lesson) return tl::unexpected(std::move(lesson.error()));
    lessons.push_back(std::move(*lesson));
  }
  std::sort(lessons.begin(), lessons.end(),
            [](const LessonFile& a, const LessonFile& b) { return lesson::comes_before(a.lesson, b.lesson); });
  return lessons;
}

tl::expected<LessonFile, InputError> find_lesson(const std::string& folder, const std::string& id,
                                                 lesson::Checked checked) {
  const auto paths = toml_files(folder_or_own(folder));
  if (!paths) return tl::unexpected(paths.error());
  for (const std::string& path : *paths)
    if (fs::path(path).stem() == id) return read_lesson_file(path, checked);
  return tl::unexpected(InputError{.what = "there is no lesson \"" + id + "\"; `snug lesson list` lists them"});
}

tl::expected<std::unique_ptr<lesson::Subject>, InputError> subject_of(const LessonFile& file) {
  auto mesh = mesh_of(file.lesson);
  if (!mesh) return tl::unexpected(std::move(mesh.error()));
  auto subject = file.lesson.subject->open(file.lesson, *std::move(mesh), nullptr);
  if (!subject && subject.error().file.empty()) subject.error().file = file.path;
  return subject;
}

tl::expected<lesson::Session, InputError> open_lesson(const LessonFile& file) {
  auto mesh = mesh_of(file.lesson);
  if (!mesh) return tl::unexpected(std::move(mesh.error()));
  auto session = lesson::Session::open(file.lesson, std::move(*mesh));
  if (!session && session.error().file.empty()) session.error().file = file.path;
  return session;
}

}  // namespace snug::desktop
