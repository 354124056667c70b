// A program whose lessons ask nothing of an algorithm's trace: see snug_program() in CMakeLists.txt.
#include "lesson/ask.hpp"

namespace snug::lesson {

std::vector<Asked> asked_on(const Lesson&, std::string_view, Trace, int, bool) { return {}; }
std::optional<Asked> resolve(const Question&, std::string_view, Trace, int, std::string&) { return std::nullopt; }
bool answers(const Asked&, const Answer&, Index) { return false; }
Outcome judge(const Asked&, const Answer&, Trace) { return {}; }
Answer model_answer(const Asked&, Trace) { return {}; }

}  // namespace snug::lesson
