// What must hold of a lesson as a whole: its questions on the trace of its own points, and its task.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// lesson: of a file that reads well. A lesson on a mesh is run by those who have the mesh: its questions are not
/// checked against a trace here.
void check_lesson(const Lesson& lesson, const toml::table& toml, Complaints& complaints);

}  // namespace snug::lesson
