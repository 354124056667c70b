// The lessons of this clone, as tests of the front end read them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/point_file.hpp"
#include "lesson/lesson.hpp"

namespace snug::app {

/// lessons/ID.toml as it is written; "cases/twins" is that of a case. asks: with its questions. The test ends where the
/// lesson is not sound.
lesson::Lesson course_lesson(const std::string& id, bool asks = true);
/// All of them but the cases.
std::vector<lesson::Lesson> all_lessons(bool asks = true);
/// A prepared mesh, as a door gives it to a lesson; none of no name.
std::optional<io::PointFile> mesh_of(const std::string& mesh);

}  // namespace snug::app
