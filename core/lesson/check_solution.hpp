#pragma once

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// Checks that a task is not solved by what it begins with, and that its model solves it.
void check_solution(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints);

}  // namespace snug::lesson
