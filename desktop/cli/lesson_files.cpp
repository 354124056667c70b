#include "desktop/cli/lesson_files.hpp"

#include <algorithm>
#include <iterator>

#include "check/check_lesson.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/defaults.hpp"
#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/sheet_files.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

fs::path folder_or_own(const std::string& folder) { return folder.empty() ? lessons_folder() : fs::path(folder); }

/// The folder of the named cases, which come with the program.
constexpr const char* kCases = "cases";
std::string folder_of_cases() { return (data_folder() / "lessons" / kCases).string(); }

/// Hidden files are an editor's own; a pipe would be waited for.
bool is_lesson(const fs::directory_entry& entry) {
  const fs::path& path = entry.path();
  std::error_code error;
  return entry.is_regular_file(error) && path.extension() == ".toml" && path.filename() != kCourseFile &&
         !path.filename().string().starts_with('.');
}

tl::expected<std::vector<std::string>, InputError> toml_files(const fs::path& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (is_lesson(entry)) paths.push_back(entry.path().string());
  if (error)
    return tl::unexpected(
        InputError{.what = "the lessons cannot be read: " + error.message(), .file = folder.string()});
  std::sort(paths.begin(), paths.end());  // so that of several errors the same one is always reported
  return paths;
}

std::vector<std::string> ids_of(const std::vector<std::string>& paths) {
  std::vector<std::string> ids;
  for (const std::string& path : paths) ids.push_back(id_of(path));
  return ids;
}

tl::expected<lesson::Course, InputError> course_of(const fs::path& folder, const std::vector<std::string>& paths) {
  const fs::path path = folder / kCourseFile;
  std::error_code error;
  if (!fs::exists(path, error)) return {};
  return read_start(path.string(), lesson::kMostLessonBytes).and_then([&](const std::string& text) {
    return lesson::read_course(text, path.string(), ids_of(paths));
  });
}

/// The file of a case; none if there is none of that name, or no folder of cases.
std::optional<std::string> path_of_case(const std::string& name) {
  if (const auto paths = toml_files(folder_of_cases()))
    for (const std::string& path : *paths)
      if (id_of(path) == name) return path;
  return std::nullopt;
}

/// The file of a lab sheet; none if there is none of that id.
std::optional<std::string> path_of_sheet(const std::string& folder, const std::string& id) {
  if (const auto paths = toml_files(folder_in_lessons(folder, "labs")))
    for (const std::string& path : *paths)
      if (id_of(path) == id) return path;
  return std::nullopt;
}

/// Whether a path is that of a lab sheet. A pipe can be read only once, and is none.
bool is_sheet_file(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  const auto text = read_start(path, lesson::kMostLessonBytes);
  return text && lesson::is_sheet(*text);
}

}  // namespace

std::vector<LessonFile> in_order(std::vector<LessonFile> lessons, const lesson::Course& course) {
  std::vector<LessonFile> sorted;
  for (const lesson::Chapter& chapter : course.chapters)
    for (const std::string& id : chapter.lessons) {
      const auto is_it = [&](const LessonFile& file) { return file.lesson.id == id; };
      const auto found = std::find_if(lessons.begin(), lessons.end(), is_it);
      if (found == lessons.end()) continue;
      found->chapter = chapter.title;
      sorted.push_back(std::move(*found));
      lessons.erase(found);
    }
  std::move(lessons.begin(), lessons.end(), std::back_inserter(sorted));
  return sorted;
}

InputError no_lessons(const std::string& folder) {
  return {.what = "there is no lesson: no file here ends in .toml", .file = folder};
}

bool is_path(std::string_view lesson) { return lesson.ends_with(".toml"); }

std::string id_of(const std::string& path) { return fs::path(path).stem().string(); }

tl::expected<std::vector<std::string>, InputError> lesson_paths(const std::string& folder) {
  return toml_files(folder_or_own(folder));
}

tl::expected<LessonFile, InputError> read_lesson_file(const std::string& path, Read how) {
  return read_start(path, lesson::kMostLessonBytes)
      .and_then([&](const std::string& text) {
        return how == Read::kChecked ? check::checked_lesson(text, path) : lesson::read_lesson(text, path);
      })
      .map([&](lesson::Lesson&& lesson) {
        return LessonFile{path, std::move(lesson), {}};
      });
}

tl::expected<lesson::Course, InputError> read_course_of(const std::string& folder) {
  const fs::path where = folder_or_own(folder);
  return toml_files(where).and_then([&](const std::vector<std::string>& paths) { return course_of(where, paths); });
}

tl::expected<std::vector<std::string>, InputError> files_of(const std::string& folder) {
  auto paths = toml_files(folder_or_own(folder));
  if (!paths) return paths;
  const fs::path course = folder_or_own(folder) / kCourseFile;
  std::error_code error;
  if (fs::exists(course, error)) paths->push_back(course.string());
  if (paths->empty()) return tl::unexpected(no_lessons(folder));
  return paths;
}

tl::expected<std::vector<LessonFile>, InputError> read_lessons(const std::string& folder) {
  const fs::path where = folder_or_own(folder);
  const auto paths = toml_files(where);
  if (!paths) return tl::unexpected(paths.error());
  const auto course = course_of(where, *paths);
  if (!course) return tl::unexpected(course.error());
  std::vector<LessonFile> lessons;
  for (const std::string& path : *paths) {
    auto lesson = read_lesson_file(path);
    if (!lesson) return tl::unexpected(std::move(lesson.error()));
    lesson->slides = lesson::slides_of(*course, lesson->lesson.covers);
    lesson->is_playground = lesson->lesson.id == course->playground;
    lessons.push_back(std::move(*lesson));
  }
  return in_order(std::move(lessons), *course);
}

fs::path folder_in_lessons(const std::string& lessons, const std::string& name) {
  std::error_code error;
  if (!lessons.empty()) return fs::path(lessons) / name;
  const fs::path own = lessons_folder() / name;
  return fs::exists(own, error) ? own : data_folder() / "lessons" / name;
}

std::vector<std::string> lesson_ids(const std::string& folder) {
  const auto paths = toml_files(folder_or_own(folder));
  return paths ? ids_of(*paths) : std::vector<std::string>();
}

InputError no_lesson(const std::string& folder, const std::string& id) {
  const std::string list = "`snug lesson list" + (folder.empty() ? "" : " --lessons " + folder) + '`';
  return {.what = "there is no lesson \"" + id + "\"; " + list + " lists them" + did_you_mean(id, lesson_ids(folder))};
}

tl::expected<LessonFile, InputError> find_lesson(const std::string& folder, const std::string& id, Read how) {
  if (is_path(id)) return is_sheet_file(id) ? read_sheet_file(id) : read_lesson_file(id, how);
  const auto paths = toml_files(folder_or_own(folder));
  if (!paths) return tl::unexpected(paths.error());
  for (const std::string& path : *paths)
    if (id_of(path) == id) return read_lesson_file(path, how);
  if (const auto path = folder.empty() ? path_of_case(id) : std::nullopt) return read_lesson_file(*path, how);
  if (const auto path = path_of_sheet(folder, id)) return read_sheet_file(*path);
  return tl::unexpected(no_lesson(folder, id));
}

tl::expected<std::vector<LessonFile>, InputError> read_cases() {
  return read_lessons(folder_of_cases()).map([](std::vector<LessonFile>&& cases) {
    for (LessonFile& file : cases) file.is_case = true;
    return std::move(cases);
  });
}

tl::expected<LessonFile, InputError> find_case(const std::string& name) {
  if (const auto path = path_of_case(name)) return read_lesson_file(*path, Read::kAsWritten);
  return tl::unexpected(InputError{.what = "there is no case \"" + name + "\"; `snug cases` lists them" +
                                           did_you_mean(name, lesson_ids(folder_of_cases()))});
}

check::Beside beside(const std::string& path) {
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
  check::Beside beside;
  const auto add = [&](const fs::path& from) {
    if (const auto paths = toml_files(from))
      for (std::string& id : ids_of(*paths)) beside.lessons.push_back(std::move(id));
  };
  add(folder);
  add(folder.filename() == kCases ? folder / ".." : folder / kCases);  // links go both ways
  if (const auto course = read_course_of(folder.string()))             // what is wrong with it is told of its own file
    for (const lesson::Idea& idea : course->ideas) beside.ideas.push_back(idea.id);
  return beside;
}

tl::expected<std::optional<io::PointFile>, InputError> mesh_of(const lesson::Lesson& lesson) {
  if (lesson.points.mesh.empty()) return std::nullopt;
  return mesh_named(lesson.points.mesh).map([](io::PointFile&& mesh) { return std::optional(std::move(mesh)); });
}

tl::expected<io::PointFile, InputError> mesh_named(const std::string& name) {
  return read_point_file((data_folder() / "assets" / "meshes" / (name + ".ply")).string());
}

InputError with_column(const lesson::FileError& error) {
  return {error.what, error.file + ':' + std::to_string(error.place.line) + ':' + std::to_string(error.place.column)};
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
