// Checks a lesson as a whole: its questions, on the trace of its own points, and its tasks.
#pragma once

#include "io/point_file.hpp"
#include "lesson/lesson.hpp"

namespace snug::check {

using namespace lesson;

/// Reads a lesson file, and runs each situation that opens; that may take seconds. Besides what reading finds, these
/// are mistakes: a question whose step the algorithm does not take on the lesson's own points, or a model solution that
/// the task does not accept. Its warnings are what a file may say and its author probably did not mean. Questions,
/// tasks and sliders with mistakes are left out. mesh: that of a lesson on a mesh, which is not run without it.
[[nodiscard]] Draft checked_draft(std::string_view toml, std::string_view name, const io::PointFile* mesh = nullptr);

/// The lesson of a file without mistakes. Errors: the first mistake.
[[nodiscard]] tl::expected<Lesson, InputError> checked_lesson(std::string_view toml, std::string_view name);

}  // namespace snug::check
