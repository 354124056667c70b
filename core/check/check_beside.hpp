// Checks a lesson against what stands beside its file, and by playing it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_file.hpp"
#include "lesson/lesson.hpp"

namespace snug::check {

using namespace lesson;

/// What stands beside a lesson's file.
struct Beside {
  std::vector<std::string> lessons;  // the ids of the folder's lessons
  std::vector<std::string> ideas;    // the ids of the ideas that its course lists; empty if it lists none
};

/// Adds the mistakes that the file alone does not show: links to lessons and ideas that are not there. file: its name
/// in the mistakes.
void check_names_beside(Draft& draft, std::string_view file, const Beside& beside);

/// Adds the mistakes that only playing shows, such as questions that are never asked. mesh: the one that the lesson
/// begins with, if any. Does nothing if the draft has mistakes.
void check_played(Draft& draft, std::string_view file, std::optional<io::PointFile> mesh);

}  // namespace snug::check
