// Reads lessons and their meshes from the disk.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "check/check_beside.hpp"
#include "geometry/input_error.hpp"
#include "lesson/course.hpp"
#include "lesson/session.hpp"
#include "lesson/sheet.hpp"

namespace snug::desktop {

struct LessonFile {
  std::string path;
  lesson::Lesson lesson;
  std::string chapter;  // the chapter's title; empty if the folder has no course, or if the lesson was read alone
  std::vector<std::string> slides = {};             // those that it covers, by the course's list
  bool is_case = false;                             // a named case, and no lesson of the course
  bool is_playground = false;                       // whether it is the course's playground
  std::shared_ptr<const lesson::Sheet> sheet = {};  // of a lab sheet; null for none
  /// Whether it is one of the course's lessons, and neither a case nor a sheet.
  [[nodiscard]] bool of_course() const { return !is_case && sheet == nullptr; }
};

/// The file in a folder that lists the lessons of its course.
inline constexpr std::string_view kCourseFile = "course.toml";

/// How a lesson is read: as it is written, or also run and checked, which may take seconds.
enum class Read : std::uint8_t { kAsWritten, kChecked };

/// Errors: those of the file and of its content, each with the path.
[[nodiscard]] tl::expected<LessonFile, InputError> read_lesson_file(const std::string& path, Read how = Read::kChecked);

/// Whether a lesson is named by its file's path, not by its id: it ends in .toml.
[[nodiscard]] bool is_path(std::string_view lesson);
/// The id of the lesson in a file: the file's name without .toml.
[[nodiscard]] std::string id_of(const std::string& path);

/// The paths of a folder's lessons, by name; "" is the program's own folder. Errors: those of the folder.
[[nodiscard]] tl::expected<std::vector<std::string>, InputError> lesson_paths(const std::string& folder);

/// What `read` makes of each file. Errors: that of the first bad one.
template <class Reader, class One = typename std::invoke_result_t<Reader&, const std::string&>::value_type>
[[nodiscard]] tl::expected<std::vector<One>, InputError> read_each(const std::vector<std::string>& paths, Reader read) {
  std::vector<One> all;
  for (const std::string& path : paths) {
    auto one = read(path);
    if (!one) return tl::unexpected(std::move(one.error()));
    all.push_back(*std::move(one));
  }
  return all;
}

/// A folder in that of the lessons: "exercises". A class's lessons may come without it: then it is the program's own.
[[nodiscard]] std::filesystem::path folder_in_lessons(const std::string& lessons, const std::string& name);

/// The course of a folder; none if it has no course file. Errors: those of lesson::read_course.
[[nodiscard]] tl::expected<lesson::Course, InputError> read_course_of(const std::string& folder);

/// The error of a folder without lessons.
[[nodiscard]] InputError no_lessons(const std::string& folder);

/// The paths of a folder's lessons, by name, and of its course file at the end. Errors: those of the folder; it has
/// none of these files.
[[nodiscard]] tl::expected<std::vector<std::string>, InputError> files_of(const std::string& folder);

/// Every lesson of a folder in the order of its course, or by id if it has none; "" is the program's own folder.
/// Errors: those of the folder, and of the first bad file.
[[nodiscard]] tl::expected<std::vector<LessonFile>, InputError> read_lessons(const std::string& folder);

/// The lesson with an id in a folder, or of the file that a path leads to; without a folder, a case as well. Errors:
/// those of its file; no such lesson.
[[nodiscard]] tl::expected<LessonFile, InputError> find_lesson(const std::string& folder, const std::string& id,
                                                               Read how = Read::kChecked);

/// The named cases, on which programs are known to fail: lessons without questions, in a folder of their own, in the
/// order of its course. Errors: as of read_lessons.
[[nodiscard]] tl::expected<std::vector<LessonFile>, InputError> read_cases();
/// The case of a name. Errors: those of its file; no such case.
[[nodiscard]] tl::expected<LessonFile, InputError> find_case(const std::string& name);

/// The ids of a folder's lessons, by name; none if it cannot be read.
[[nodiscard]] std::vector<std::string> lesson_ids(const std::string& folder);

/// Says that a folder has no lesson with an id.
[[nodiscard]] InputError no_lesson(const std::string& folder, const std::string& id);

/// What stands beside a lesson's file, as far as it can be read.
[[nodiscard]] check::Beside beside(const std::string& path);

/// The mesh that a lesson begins with; none if it has none. Errors: those of its file.
[[nodiscard]] tl::expected<std::optional<io::PointFile>, InputError> mesh_of(const lesson::Lesson& lesson);
/// One of the program's meshes, by name. Errors: those of its file.
[[nodiscard]] tl::expected<io::PointFile, InputError> mesh_named(const std::string& name);

/// Sorts lessons into a course's order, with their chapters; those that it does not list come last.
[[nodiscard]] std::vector<LessonFile> in_order(std::vector<LessonFile> lessons, const lesson::Course& course);

/// What is wrong in a file, with its column, which other files' errors do not have.
[[nodiscard]] InputError with_column(const lesson::FileError& error);

/// The lesson's subject as it opens. Errors: those of the mesh's file and of the subject's open, with a path.
[[nodiscard]] tl::expected<std::unique_ptr<lesson::Subject>, InputError> subject_of(const LessonFile& file);

/// Opens a lesson, with its mesh if it has one. Errors: those of Session::open, with the lesson's path.
[[nodiscard]] tl::expected<lesson::Session, InputError> open_lesson(const LessonFile& file);

}  // namespace snug::desktop
