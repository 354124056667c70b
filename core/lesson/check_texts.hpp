// Checks the markup of prompts, reasons and hints, and the figures of the run in all texts.
#pragma once

#include <functional>
#include <string>

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The run of one of the lesson's algorithms on its own points; null if it cannot take them.
using RunOf = std::function<const Run*(const std::string& algorithm)>;

/// Complains about the markup of the texts of questions and tasks, and about figures of algorithms that the lesson does
/// not offer; collects the figures of the lesson. toml: the lesson's file, whose sections were read.
void read_texts(const toml::table& toml, Lesson& lesson, Complaints& complaints);

/// Complains about figures that the runs do not have. own: the lesson's subject as it opens.
void check_figures(const Lesson& lesson, const toml::table& toml, const Subject& own, const RunOf& run_of,
                   Complaints& complaints);

/// Why there is no such figure: "is none of radius or excess: exces; did you mean excess?"; empty if there is one.
/// algorithm: in whose run it is shown, if it names none itself; empty: in that of any.
[[nodiscard]] std::string lack_of(const RunFigure& figure, const std::string& algorithm, const Lesson& lesson,
                                  const Subject& own, const RunOf& run_of);

}  // namespace snug::lesson
