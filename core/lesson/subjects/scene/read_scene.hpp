// The parts of a lesson's file that only a scene has.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/subjects/scene/scene_set.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// What a task on a scene requires of the figures of its last frame.
struct SceneTask : Tables {
  struct Requirement {
    std::string figure;  // one of scene_figure_names()
    static constexpr double kNoMost = 1e300;
    double at_least = 0, at_most = kNoMost;
  };
  std::vector<Requirement> requirements;
};

/// Reads [scene] of the lesson's table. dim: that of its points, which must be 3.
[[nodiscard]] SceneSet read_scene_of(TomlTable& lesson, int dim, Complaints& complaints);

/// Reads "figure" and "bounds" of a question.
void read_ranges(TomlTable& table, Question& question);

void read_scene_task(TomlTable& table, Lesson& lesson, Complaints& complaints);

}  // namespace snug::lesson
