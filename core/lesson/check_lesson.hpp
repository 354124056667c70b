// Checks a lesson as a whole: its questions, on the trace of its own points, and its task.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// lesson: read without errors. The questions of a lesson on a mesh are not checked here, because the mesh is not
/// available.
void check_lesson(const Lesson& lesson, const toml::table& toml, Complaints& complaints);

}  // namespace snug::lesson
