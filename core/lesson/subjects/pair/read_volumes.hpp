// [volumes] of a lesson's file.
#pragma once

#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/volumes.hpp"

namespace snug::lesson {

struct VolumeTables : Tables {
  VolumePair pair;
  bool in_float = false;         // whether the volumes are rounded to float, and tested in it
  std::array<bool, 2> stored{};  // whether the lesson shows how A and how B is stored (lesson/stored.hpp)
  int line = 1;                  // that of the table
};

/// Reads a and b (read_held_volume).
void read_volumes(TomlTable& table, Lesson& lesson, Complaints& complaints);
/// Reads a task's "model", a table with a and b of the lesson's kinds.
[[nodiscard]] Rows read_volume_model(TomlTable& task, const Lesson& lesson, Complaints& complaints);
/// Checks that every algorithm is a test of this pair.
void check_volume_tests(const Lesson& lesson, const Subject& own, Complaints& complaints);

}  // namespace snug::lesson
