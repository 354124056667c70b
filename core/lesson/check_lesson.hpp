// Checks a lesson as a whole: its questions, on the trace of its own points, and its task.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/read_situations.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// What a lesson is checked with.
struct CheckedWith {
  Checked checked;
  const io::PointFile* mesh;  // null: a lesson on a mesh is not run
  const Stages& stages;
};

/// lesson: what could be read of its file. Each situation that opens is run, and all that can be checked there is, in
/// spite of mistakes elsewhere; questions, tasks and sliders with mistakes are then removed. Returns whether the lesson
/// can be shown.
[[nodiscard]] bool check_lesson(Lesson& lesson, const toml::table& toml, const CheckedWith& with,
                                Complaints& complaints);

/// Checks that a task is not solved by what it begins with, and that its model solves it.
void check_solution(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints);

}  // namespace snug::lesson
