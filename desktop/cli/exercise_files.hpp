// Reads exercises and their sets from the disk, and result files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "desktop/cli/json.hpp"
#include "lesson/exercise/attempt.hpp"
#include "lesson/exercise/sets.hpp"

namespace snug::desktop {

struct ExerciseFile {
  std::string path;
  std::shared_ptr<const lesson::Exercise> exercise;
};

/// The exercises of a lessons folder ("" is the one beside the program), by id. Errors: those of the folder, and of the
/// first bad file.
[[nodiscard]] tl::expected<std::vector<ExerciseFile>, InputError> read_exercises(const std::string& folder);
/// The exercise with an id, or of the file that a path leads to. Errors: those of its file; no such exercise.
[[nodiscard]] tl::expected<ExerciseFile, InputError> find_exercise(const std::string& folder, const std::string& id);
/// The sets of a lessons folder. Errors: those of the folder and of the file.
[[nodiscard]] tl::expected<std::vector<lesson::ExerciseSet>, InputError> read_sets_of(const std::string& folder);

/// An attempt of a result file, and what the file says of it.
struct Claimed {
  lesson::Attempt attempt;
  std::optional<double> mark;  // what it claims to have earned
};

/// A result file (README of lessons): one student's attempts.
struct ResultFile {
  int format = 0;
  std::string version;  // of the program that wrote it
  std::string student;
  std::vector<tl::expected<Claimed, std::string>> attempts;  // or what is wrong with one
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

/// The text of a result file with these attempts.
[[nodiscard]] std::string result_text(const std::string& student, const std::vector<Json>& attempts);

}  // namespace snug::desktop
