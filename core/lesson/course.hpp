// The course: which lessons there are, in which order, under which chapters, as lessons/course.toml says it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"

namespace snug::lesson {

struct Chapter {
  std::string title;
  std::vector<std::string> lessons;  // their ids, in order
};

struct Course {
  std::vector<Chapter> chapters;
};

/// Reads a course file. name: for errors. ids: the lessons that there are. Errors: of TOML, of an unknown or missing
/// key, of a lesson that there is not, stands twice or in no chapter; each with its line.
[[nodiscard]] tl::expected<Course, InputError> read_course(std::string_view toml, std::string_view name,
                                                           std::span<const std::string> ids);

}  // namespace snug::lesson
