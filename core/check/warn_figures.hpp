// Numbers in a lesson's prose that a figure of the run could give.
#pragma once

#include "check/check_figures.hpp"

namespace snug::check {

using namespace lesson;

/// Warns of each number in a text that is a figure of one of the lesson's runs at its end: it is false once the student
/// drags a point, where {the figure} is not. Counts are told in sections alone. Texts that are only said of the
/// lesson's own run are left out, and so are tasks, whose numbers are what is to be reached.
void warn_of_figures(const Lesson& lesson, const toml::table& toml, std::span<const OpenSituation> situations,
                     Complaints& complaints);

}  // namespace snug::check
