// Tries a student's JavaScript in the engine of the page, which Node runs: the same bytes, so the same answers.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "write/judge.hpp"

namespace snug::desktop {

/// An exercise that is written, as result files name it: "write:overlap-min-max".
inline constexpr std::string_view kWritePrefix = "write:";

[[nodiscard]] inline bool is_written(std::string_view exercise) { return exercise.starts_with(kWritePrefix); }

/// What became of a code, and what it threw first; empty if it did not.
struct JudgedJs {
  write::Judged judged;
  std::string error;
};

/// Tries codes one after the other. Errors: why they could not be tried here.
[[nodiscard]] tl::expected<std::vector<JudgedJs>, std::string>
judge_js(const write::Function& function, const std::vector<std::string>& codes, std::uint64_t seed);

}  // namespace snug::desktop
