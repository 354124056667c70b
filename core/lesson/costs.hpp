// What a lesson with the chart of costs asks and grades, by what was measured: core/measure's rows, one for each
// algorithm of the lesson, in its order.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/grade.hpp"
#include "measure/rows.hpp"

namespace snug::lesson {

using Costs = std::span<const cost::CostRow>;

/// Its questions, all of which stand before the measurement; their step is -1, which is none of the player's.
[[nodiscard]] std::vector<Asked> asked_of_costs(const Lesson& lesson);

/// Whether that is an answer to it. Of a question with many answers the value's bits are the choices.
[[nodiscard]] bool answers_of_costs(const Asked& asked, const Answer& answer);

/// What was predicted, pending until it is decided.
[[nodiscard]] Outcome predicted(const Asked& asked, const Answer& answer);
/// Anew, whatever was decided before. No front is decided by a row that was measured badly: it stays pending.
void decide(const Asked& asked, Costs rows, Outcome& outcome);

/// An answer that is right.
[[nodiscard]] Answer model_answer(const Asked& asked, Costs rows);

/// chosen: the algorithm that stands on the stage. rows: those of the task's points.
[[nodiscard]] Grade grade_costs(const Task& task, Costs rows, std::string_view chosen);
/// The least time that is smaller by as much as the task asks; empty where none is.
[[nodiscard]] std::string_view cheapest_of(const Task& task, Costs rows);

/// The rows with operations in the place of nanoseconds, and no repeats, for who has no clock: a check of the lesson.
/// All on all points. What is decided and graded by them speaks of operations.
[[nodiscard]] std::vector<cost::CostRow> counted_costs(const Lesson& lesson, const AnyPointSet& points);

}  // namespace snug::lesson
