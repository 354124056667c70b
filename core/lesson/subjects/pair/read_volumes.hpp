// [volumes] of a lesson's file.
#pragma once

#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/volumes.hpp"

namespace snug::lesson {

struct VolumeTables : Tables {
  VolumePair pair;
  int line = 1;  // of the table
};

/// a, b: each a table with the kind of the volume, whose fields are named as in `snug overlap`; but for an oriented
/// box, which has "turn" in degrees in the place of its axes.
void read_volumes(TomlTable& table, Lesson& lesson, Complaints& complaints);
void refuse_volume_task(TomlTable& table, Lesson& lesson, Complaints& complaints);
/// Every algorithm is the pair's own test, or GJK.
void check_volume_tests(const Lesson& lesson, const Subject& own, Complaints& complaints);

}  // namespace snug::lesson
