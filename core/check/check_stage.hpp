// Checks what a lesson's file says of its stage: its sliders and its [view].
#pragma once

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::check {

using namespace lesson;

/// Checks that the sliders of a situation drive something, and can do so from one end to the other. A misspelt name is
/// replaced by what is meant; sliders with other mistakes are no longer sound. subject: that situation's, before any
/// slider has moved.
void check_sliders(Lesson& lesson, const Subject& subject, Complaints& complaints);

[[nodiscard]] std::vector<std::string> names_of_handles(const Subject& own);
/// "; did you mean P5?", or what else is there.
[[nodiscard]] std::string meant_text(const std::vector<std::string>& names, const std::string& name);

/// Checks of [view] what depends on the subject: its handles, its dimension, whether it has points or a gap.
void check_view(const StageView& view, const toml::table& lesson, const Subject& own, Complaints& complaints);

}  // namespace snug::check
