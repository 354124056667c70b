// Checks a lesson as a whole: its questions, on the trace of its own points, and its task.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// lesson: what could be read of its file; questions that prove wrong on the run are removed from it. The questions of
/// a lesson on a mesh are not checked on a run here, because the mesh is not available. Returns
/// whether it can be run.
[[nodiscard]] bool check_lesson(Lesson& lesson, const toml::table& toml, Checked checked, Complaints& complaints);

/// Checks that a task is not solved by what it begins with, and that its model solves it.
void check_solution(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints);

}  // namespace snug::lesson
