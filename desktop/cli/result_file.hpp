// A result file: what one student hands in (README of lessons).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/json.hpp"
#include "lesson/exercise/attempt.hpp"

namespace snug::desktop {

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
