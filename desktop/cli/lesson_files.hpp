// Lessons and their meshes on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/input_error.hpp"
#include "lesson/session.hpp"

namespace snug::desktop {

struct LessonFile {
  std::string path;
  lesson::Lesson lesson;
};

/// Errors: of the file, of its form, each with the path.
[[nodiscard]] tl::expected<LessonFile, InputError> read_lesson_file(const std::string& path,
                                                                    lesson::Checked checked = lesson::Checked::kAsRun);

/// Every lesson of a folder in the order that they are listed in; "" is the folder beside the program.
/// Errors: of the folder, of the first file that is wrong.
[[nodiscard]] tl::expected<std::vector<LessonFile>, InputError> read_lessons(const std::string& folder);

/// The lesson of that id in a folder. Errors: of its file, or that there is none.
[[nodiscard]] tl::expected<LessonFile, InputError> find_lesson(const std::string& folder, const std::string& id,
                                                               lesson::Checked checked = lesson::Checked::kAsRun);

/// What stands on the lesson's stage as it opens. Errors: of the mesh's file, as of its subject's open, with a path.
[[nodiscard]] tl::expected<std::unique_ptr<lesson::Subject>, InputError> subject_of(const LessonFile& file);

/// The lesson opened, with its mesh where it has one. Errors: as of Session::open, with the lesson's path.
[[nodiscard]] tl::expected<lesson::Session, InputError> open_lesson(const LessonFile& file);

}  // namespace snug::desktop
