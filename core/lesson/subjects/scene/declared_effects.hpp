// The effects of a scene's declaration, which the student edits: adds, takes out, and is asked to build a picture with.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "lesson/figures.hpp"
#include "lesson/subject.hpp"
#include "lesson/subjects/scene/pictured.hpp"
#include "lesson/subjects/scene/scene_set.hpp"

namespace snug::lesson {

/// A 1 for each of the lesson's effects that the scene calls for, else a 0, in the order of the file. It has at least
/// four numbers, so that it is no point.
[[nodiscard]] std::vector<double> called_row(const SceneSet& set);
[[nodiscard]] inline bool is_called_row(const std::vector<double>& row) { return row.size() > 3; }
/// The scene with the effects of such a row.
[[nodiscard]] std::shared_ptr<const SceneSet> with_called(const SceneSet& set, const std::vector<double>& row);
[[nodiscard]] std::shared_ptr<const SceneSet> with_all_called(const SceneSet& set);
/// The scene with one effect called for, or taken out; null if it has none of that name.
[[nodiscard]] std::shared_ptr<const SceneSet> with_call(const SceneSet& set, std::string_view name, bool called);

/// The switches of a scene's effects, followed by those that it does not run: because it is refused, or because it does
/// not call for them.
[[nodiscard]] std::vector<Switch> with_optional(std::vector<Switch> running, const SceneSet& set);

/// Keys: effects shadows trails rays culled. Only a scene whose effects are what the lesson is about has them.
[[nodiscard]] std::vector<Figure> picture_figures(const SceneSet& set, const Pictured& pictured);

/// Reads a task's "model", a list of points, and "effects", those that the solution calls for; the lesson's own if they
/// are left out.
[[nodiscard]] Rows read_scene_model(TomlTable& task, const Lesson& lesson, Complaints& complaints);

}  // namespace snug::lesson
