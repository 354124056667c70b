// Reads lab sheets from the disk; what a student has done of one, as it is kept and handed in.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/sheet.hpp"

namespace snug::desktop {

/// The sheets of a lessons folder ("" is the program's own), in the order of their course. Each is a lesson with the
/// sheet beside it. Errors: those of the folder, and of the first bad file.
[[nodiscard]] tl::expected<std::vector<LessonFile>, InputError> read_sheets(const std::string& folder);
/// Errors: those of the file.
[[nodiscard]] tl::expected<LessonFile, InputError> read_sheet_file(const std::string& path);

/// A table that was measured, and the day.
struct MeasuredTable {
  std::string date;  // "2026-11-28"
  Json table;        // as `snug cost --json` prints it
};

/// What a student has done of a sheet: by the ids of its parts, and by the number of each task.
struct SheetWork {
  std::map<std::string, std::string> written;
  std::map<std::string, MeasuredTable> measured;
  std::map<std::size_t, lesson::Rows> built;
};

/// "3 of 4 parts are missing."; empty if all are there.
[[nodiscard]] std::string missing_of(const lesson::Sheet& sheet, const SheetWork& work);

/// The object that stands for it in a result file: {"sheet","hash","written","measured","built"}.
[[nodiscard]] Json json_of(const std::string& id, std::uint64_t hash, const SheetWork& work);
/// Reads such an object. Errors: what is wrong with it.
struct ClaimedSheet {
  std::string sheet, hash;
  SheetWork work;
};
[[nodiscard]] tl::expected<ClaimedSheet, std::string> sheet_of(const Json& json);

/// Today, as a table says it, in this machine's time.
[[nodiscard]] std::string today();

}  // namespace snug::desktop
