// The parts of a lesson's file that only a scene has.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/subjects/scene/scene_set.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// Reads [scene] of the lesson's table. dim: that of its points, which must be 3.
[[nodiscard]] SceneSet read_scene_of(TomlTable& lesson, int dim, Complaints& complaints);

/// Reads the table [scene] itself. has_mesh: whether bodies may have a mesh's shape. graph: where it does not say so.
[[nodiscard]] SceneSet read_scene_table(const toml::table& scene, bool has_mesh, bool graph, Complaints& complaints);

/// Reads "figure" and "bounds" of a question.
void read_ranges(TomlTable& table, Question& question);

}  // namespace snug::lesson
