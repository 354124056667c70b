// The grading of a lesson's task on the points as they stand.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/point_set.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {

struct Grade {
  bool done = false;
  int points = 0;     // how many there are
  double excess = 0;  // its size / the smallest - 1, as fit::size_of has sizes
  int support = 0;    // how many points hold the smallest volume
  std::string says;   // what is reached and what is not, in a sentence or two
};

/// seed: of the algorithm's random order. The task's algorithm is one of the catalogue.
[[nodiscard]] Grade grade(const Task& task, const AnyPointSet& points, std::uint64_t seed);

/// Grades a scene on its last frame. seed: that of what the scene scatters.
[[nodiscard]] Grade grade_scene(const Task& task, const SceneSet& scene, const AnyPointSet& points, std::uint64_t seed);

/// Whether two boxes, or a box and a frustum, reach a goal of Task::goals.
[[nodiscard]] bool reaches(std::string_view goal, const BoxPair& pair);

/// found: which of the task's goals were reached before; those that are reached now are added.
[[nodiscard]] Grade grade_boxes(const Task& task, const BoxPair& pair, std::vector<bool>& found);

}  // namespace snug::lesson
