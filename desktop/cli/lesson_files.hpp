// Lessons and their meshes on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/input_error.hpp"
#include "lesson/course.hpp"
#include "lesson/session.hpp"

namespace snug::desktop {

struct LessonFile {
  std::string path;
  lesson::Lesson lesson;
  std::string chapter;  // its title; empty where the folder has no course, or where the lesson was read alone
};

/// The file of a folder that says which lessons its course has.
inline constexpr std::string_view kCourseFile = "course.toml";

/// Errors: of the file, of its form, each with the path.
[[nodiscard]] tl::expected<LessonFile, InputError> read_lesson_file(const std::string& path,
                                                                    lesson::Checked checked = lesson::Checked::kAsRun);

/// The course of a folder, or none where it has no course file. Errors: as of lesson::read_course.
[[nodiscard]] tl::expected<lesson::Course, InputError> read_course_of(const std::string& folder);

/// The paths of a folder's lessons by name, and of its course file at the end. Errors: of the folder.
[[nodiscard]] tl::expected<std::vector<std::string>, InputError> files_of(const std::string& folder);

/// Every lesson of a folder in the order of its course, by their ids where it has none; "" is the folder beside the
/// program. Errors: of the folder, of the first file that is wrong.
[[nodiscard]] tl::expected<std::vector<LessonFile>, InputError> read_lessons(const std::string& folder);

/// The lesson of that id in a folder. Errors: of its file, or that there is none.
[[nodiscard]] tl::expected<LessonFile, InputError> find_lesson(const std::string& folder, const std::string& id,
                                                               lesson::Checked checked = lesson::Checked::kAsRun);

/// What stands on the lesson's stage as it opens. Errors: of the mesh's file, as of its subject's open, with a path.
[[nodiscard]] tl::expected<std::unique_ptr<lesson::Subject>, InputError> subject_of(const LessonFile& file);

/// The lesson opened, with its mesh where it has one. Errors: as of Session::open, with the lesson's path.
[[nodiscard]] tl::expected<lesson::Session, InputError> open_lesson(const LessonFile& file);

}  // namespace snug::desktop
