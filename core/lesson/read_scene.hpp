// The parts of a lesson's file that only a scene has.
#pragma once

#include <string>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// [scene] of the lesson's table. dim: of its points, which must be 3.
[[nodiscard]] SceneSet read_scene_of(TomlTable& lesson, int dim, Complaints& complaints);

/// "figure" and "bounds" of a question.
void read_ranges(TomlTable& table, Question& question);

/// [task] of a scene. algorithms: those of the lesson.
[[nodiscard]] Task read_scene_task(const toml::table& toml, const std::vector<std::string>& algorithms,
                                   Complaints& complaints);

}  // namespace snug::lesson
