#include "desktop/cli/sheet_files.hpp"

#include "desktop/cli/files.hpp"

namespace snug::desktop {

namespace fs = std::filesystem;

tl::expected<LessonFile, InputError> read_sheet_file(const std::string& path) {
  const auto text = read_start(path, lesson::kMostLessonBytes);
  if (!text) return tl::unexpected(text.error());
  lesson::SheetDraft draft = lesson::read_sheet(*text, path);
  if (!draft.mistakes.empty()) return tl::unexpected(draft.mistakes.front().error());
  LessonFile file{path, draft.sheet.lesson, {}};
  file.sheet = std::make_shared<const lesson::Sheet>(std::move(draft.sheet));
  return file;
}

tl::expected<std::vector<LessonFile>, InputError> read_sheets(const std::string& folder) {
  const fs::path where = folder_in_lessons(folder, "labs");
  std::error_code error;
  if (!fs::exists(where, error)) return std::vector<LessonFile>();
  const auto paths = lesson_paths(where.string());
  const auto course = read_course_of(where.string());
  if (!paths) return tl::unexpected(paths.error());
  if (!course) return tl::unexpected(course.error());
  return read_each(*paths, read_sheet_file).map([&](std::vector<LessonFile>&& sheets) {
    return in_order(std::move(sheets), *course);
  });
}

}  // namespace snug::desktop
