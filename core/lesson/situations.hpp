// The situations of a lesson: several sets of points, pairs or scenes, of which one is on the stage.
#pragma once

#include <string_view>
#include <vector>

#include "lesson/sliders.hpp"

namespace snug::lesson {

/// The names of all of them, the lesson's own first.
[[nodiscard]] std::vector<std::string_view> situation_names(const Lesson& lesson);
/// The words on a situation's control. name: one of these.
[[nodiscard]] const std::string& situation_title(const Lesson& lesson, std::string_view name);
/// Where its points come from.
[[nodiscard]] const Points& points_in(const Lesson& lesson, std::string_view name);
/// The lesson with that situation's points and tables as its own, and its questions, tasks and sliders alone.
[[nodiscard]] Lesson lesson_in(const Lesson& lesson, std::string_view name);

/// What stands in a situation when it is opened. mesh: the one that lesson.points.mesh names, if any. Errors: those of
/// the subject's open; a slider that drives nothing.
[[nodiscard]] tl::expected<Snapshot, InputError> open_situation(const Lesson& lesson, std::string_view name,
                                                                const std::optional<io::PointFile>& mesh, Clock clock);

}  // namespace snug::lesson
