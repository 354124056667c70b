// A lab sheet: a lesson from which the student hands in measurements, written answers and examples that were built. The
// format of its file is documented in lessons/README.md.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// A question that is answered in a line or two, for people to read.
struct Written {
  std::string id, prompt;
};

/// A table that the student's machine measures.
struct Measured {
  std::string id, prompt;
  std::string table;   // its kind: "costs", "which"
  std::string points;  // what it is measured on; empty: any points that no other of the sheet names
};

/// Each [[task]] of the lesson is an example that is built, and handed in as well.
struct Sheet {
  Lesson lesson;
  std::vector<Measured> measured;
  std::vector<Written> written;
  std::uint64_t hash = 0;  // of the file's text
};

/// What could be read of a sheet's file, and what is wrong with it.
struct SheetDraft {
  std::vector<FileError> mistakes;  // in the order of the file
  Sheet sheet;                      // sound if there are none
};

/// Whether a lesson's file is a sheet's: whether it asks for something that is measured or written.
[[nodiscard]] bool is_sheet(std::string_view toml);

/// Reads a sheet's file. name: for errors and for the id. Mistakes, each with its line and column: those of a lesson's
/// file; a table that nothing measures; two parts of one id; nothing to hand in; tasks beside measurements, for a task
/// that depends on times cannot be judged later.
[[nodiscard]] SheetDraft read_sheet(std::string_view toml, std::string_view name);

/// Which of the sheet's measurements a table is, by its kind and by what it was measured on; null for none.
[[nodiscard]] const Measured* measurement_of(const Sheet& sheet, std::string_view table, std::string_view points);

/// How long the numbers are, as they would be typed.
[[nodiscard]] std::size_t letters_of(const Rows& rows);
/// Whether an example is smaller than another: fewer rows, or as many with shorter numbers.
[[nodiscard]] bool is_smaller(const Rows& a, const Rows& b);

/// A task's example, judged as the window does. says: what is reached and what is not.
struct BuiltJudged {
  bool met = false;
  std::string says;
};
/// Errors: there is no such task; the numbers cannot stand on its stage.
[[nodiscard]] tl::expected<BuiltJudged, InputError> judge_built(const Sheet& sheet, std::size_t task, const Rows& rows);

}  // namespace snug::lesson
