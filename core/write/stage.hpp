// A case as a lesson that stands on a stage, so that a counter-example can be seen, stepped and moved.
#pragma once

#include <string>
#include <string_view>

#include "write/judge.hpp"

namespace snug::write {

/// The file of a lesson with this input on its stage. told: a text below it, a line for each of its lines. answer: a
/// wrong one, which stands beside the right one if it is a place or a volume.
[[nodiscard]] std::string lesson_of(const Function& function, const Numbers& input, const Answered& answer,
                                    std::string_view told);

/// What its stage calls what the function was given, and how the answers are drawn, in sentences; empty for neither.
/// The lesson's text has them.
[[nodiscard]] std::string words_of(const Function& function, const Numbers& input, const Answered& answer);

}  // namespace snug::write
