// Numbers in a lesson's prose that a figure of the run could give.
#pragma once

#include "lesson/check_texts.hpp"

namespace snug::lesson {

/// Warns of each number in a section's text that is a figure of one of the lesson's runs at its end: it is false once
/// the student drags a point, where {the figure} is not. toml: the section's table. own, run_of: of its situation.
void warn_of_figures(const toml::table& toml, const Section& section, const Lesson& lesson, const Subject& own,
                     const RunOf& run_of, Complaints& complaints);

}  // namespace snug::lesson
