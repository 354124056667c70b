// The sets of exercises: each belongs to a lecture, and is fit to be given as homework.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"

namespace snug::lesson {

struct ExerciseSet {
  std::string id, title;
  std::string lecture;                 // its title
  std::vector<std::string> exercises;  // their ids, in order
};

/// Reads the file of sets. name: for errors. ids: those of the existing exercises. Errors, each with its line: of TOML,
/// an unknown or missing key, an exercise that there is not, or that a set names twice; two sets of one id.
[[nodiscard]] tl::expected<std::vector<ExerciseSet>, InputError> read_sets(std::string_view toml, std::string_view name,
                                                                           std::span<const std::string> ids);

}  // namespace snug::lesson
