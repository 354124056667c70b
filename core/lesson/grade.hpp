// The grading of a lesson's task on the points as they stand.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/point_set.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {

struct Grade {
  bool done = false;
  int points = 0;          // how many there are
  double excess = 0;       // radius / smallest radius - 1
  int support = 0;         // how many points hold the smallest ball
  std::string says;        // what is reached and what is not, in a sentence or two
};

/// seed: of the algorithm's random order. The task's algorithm is one of the catalogue.
[[nodiscard]] Grade grade(const Task& task, const AnyPointSet& points, std::uint64_t seed);

}  // namespace snug::lesson
