// Fixed answers that a run tells better, or contradicts, and wrong ones without a reason.
#pragma once

#include "lesson/ask.hpp"
#include "lesson/toml_table.hpp"

namespace snug::check {

using namespace lesson;

/// What the run says instead of the fixed answer of a "choice"; none if it agrees, or cannot tell. It can tell where
/// all choices are handles, algorithms, answers to something else that the step can be asked, or values or ranges of a
/// figure that the prompt names. asked: as it is asked on the run.
[[nodiscard]] std::optional<std::string> contradiction(const Asked& asked, const Run& run);

/// Warns of a "choice" whose answer in the file the lesson's own run contradicts, and of one that a drag makes false
/// although the file says that it always holds.
void warn_of_answer(const Asked& asked, const Run& run, Complaints& complaints);

/// Warns of the choices of a "choice" that are wrong and that `wrong` says nothing about: a student would learn from
/// them only what is left.
void warn_of_reasons(const Question& question, Complaints& complaints);
/// The same of what the run decides, where it leaves a second try: the answers that are wrong on it and that nothing is
/// said to. Up to eight need a reason each; of more, two do. Numbers are told which way to go, orders are not told.
void warn_of_reasons(const Asked& asked, const Run& run, Complaints& complaints);

}  // namespace snug::check
