// Reads a lesson's situations and sliders.
#pragma once

#include "lesson/lesson.hpp"
#include "lesson/situations.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// What was read of a lesson's situations.
struct Stages {
  std::vector<std::string> unread;  // the names of those whose tables have mistakes, and which cannot be opened
  bool sound = true;                // whether none has any mistake
};

/// Reads every [[situation]], whose tables are read by the lesson's subject as its own were. Adds those that cannot be
/// opened to `unread`.
void read_situations(TomlTable& table, Lesson& lesson, std::vector<std::string>& unread, Complaints& complaints);
/// Reads every [[slider]]. What they drive is checked on the stage (check/check_stage.hpp).
void read_sliders(TomlTable& table, Lesson& lesson, Complaints& complaints);
/// Reads the "situation" of a section, a question or a slider.
[[nodiscard]] std::string read_situation(TomlTable& table, const Lesson& lesson, std::string_view otherwise);

}  // namespace snug::lesson
