// A result file: what one student hands in (README of lessons).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/json.hpp"
#include "desktop/cli/sheet_files.hpp"
#include "lesson/exercise/attempt.hpp"

namespace snug::desktop {

/// An attempt of a result file, and what the file says of it.
struct Claimed {
  lesson::Attempt attempt;
  std::optional<double> mark;       // what it claims to have earned
  std::optional<std::string> code;  // only in an exercise in which the student writes code
  bool saw_solution = false;        // before the code was handed in
};
/// Whether the decision of an exercise of that id is code: after this letter, and after ? if the solution was seen.
inline constexpr char kCodeMark = 'w';
[[nodiscard]] inline bool is_code(std::string_view exercise) {
  return exercise.starts_with("write:") || exercise.starts_with("lab:");
}

/// A result file (README of lessons): one student's attempts.
struct ResultFile {
  std::int64_t format = 0;
  std::string version;  // of the program that wrote it
  std::string student;
  std::vector<tl::expected<Claimed, std::string>> attempts;  // or what is wrong with one
  std::vector<tl::expected<ClaimedSheet, std::string>> sheets;
};

inline constexpr int kResultFormat = 1;

/// Errors: it is not JSON; `foreign` if it is no result file.
struct NoResult {
  bool foreign = false;
  std::string what;
};
[[nodiscard]] tl::expected<ResultFile, NoResult> read_result(std::string_view text);

/// Reads an object that stands for an attempt. Errors: what is wrong with it.
[[nodiscard]] tl::expected<Claimed, std::string> attempt_of(const Json& json);
/// The object that stands for an attempt in a result file.
[[nodiscard]] Json json_of(const lesson::Attempt& attempt, double mark, int of);

/// The status of what was done when the exercise was another: "older", "newer" or "foreign", by the version of the
/// program that it was done with.
[[nodiscard]] const char* status_of_another(const std::string& version);

/// The text of a result file with these attempts, and these lab sheets.
[[nodiscard]] std::string result_text(const std::string& student, const std::vector<Json>& attempts,
                                      const std::vector<Json>& sheets = {});

}  // namespace snug::desktop
