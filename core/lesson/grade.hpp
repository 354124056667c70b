// The grade of a task, for what is on the stage, and the conditions that it and some answers depend on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

class Subject;
struct View;
class TomlTable;
class Complaints;

struct Grade {
  bool done = false;
  int points = 0;     // how many points there are
  double excess = 0;  // of the requirement about an excess: 0.1 for 10 per cent
  std::string says;   // what is reached and what is not, in a sentence or two
};

/// Reads the [[….require]] of a table.
[[nodiscard]] std::vector<Requirement> read_requirements(TomlTable& table, const Lesson& lesson,
                                                         Complaints& complaints);

/// Whether a condition holds, and the sentence about it. algorithm: whose result counts if the condition names none.
/// view: the runs that are at hand; others are made.
struct Judged {
  bool met = false;
  double value = 0;       // NaN for none
  std::string unit = {};  // of the value
  std::string says;       // "Excess over the optimum: 9.8 %; it must be at least 10 %."
  bool known = true;      // false: its algorithm has no such figure, or does not take these points
};
[[nodiscard]] Judged judge_requirement(const Requirement& requirement, const Lesson& lesson, std::string_view algorithm,
                                       const Subject& subject, const View& view);

/// A bound of a figure, with its unit: "10 %", "1 point", "0.5 units".
[[nodiscard]] std::string bound_text(double bound, const std::string& unit);

/// The grade by the task's requirements.
[[nodiscard]] Grade grade_by_requirements(const Lesson& lesson, const Task& task, const Subject& subject,
                                          const View& view);

}  // namespace snug::lesson
