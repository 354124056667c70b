// What a lesson's file may say and its author probably did not mean.
#pragma once

#include <span>

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::check {

using namespace lesson;

/// subjects: as they stand in each situation when it opens; none where that is not known. Warns of handles that are not
/// there
/// ("P99" of 14 points) and of paragraphs that are too long to be read beside a stage.
void warn_of_words(const Lesson& lesson, const toml::table& toml, std::span<const Subject* const> subjects,
                   Complaints& complaints);

}  // namespace snug::check
