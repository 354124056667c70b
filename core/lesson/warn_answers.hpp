// Fixed answers that a run tells better, or contradicts.
#pragma once

#include "lesson/ask.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// Warns of a "choice" whose answer in the file the lesson's own run contradicts, and of one that a drag makes false
/// although the file says that it always holds. It can be told where all choices are handles, algorithms, or values of
/// a figure that the prompt names. asked: as it is asked on the run.
void warn_of_answer(const Asked& asked, const Run& run, Complaints& complaints);

}  // namespace snug::lesson
