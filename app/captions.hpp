// What a step says, in a student's words: one sentence for each fact.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "fit/catalogue.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// "P3", "P3 and P9", "P3, P9 and P12"; "no point" of none.
[[nodiscard]] std::string name_of_points(std::span<const Index> points);

/// One sentence on a step. next: the step after it, null where it is the last; it says what follows from this one.
/// points: those that the trace was made of. exact: whether the algorithm claims the smallest volume; the points of any
/// other's result touch it, but do not support it. best_before: of a pass that is judged, the best radius until then.
/// before: the step before it, null where it is the first; it says what a mean is of.
[[nodiscard]] std::string caption_of(const fit::Step3& step, const fit::Step3* next, const AnyPointSet& points,
                                     bool exact, std::optional<double> best_before = {},
                                     const fit::Step3* before = nullptr);

/// The sentence before the first step.
[[nodiscard]] std::string caption_at_start(const fit::Algorithm& algorithm, Index points);

/// The sentence of where the session stands.
[[nodiscard]] std::string caption_at(const lesson::Session& session);

}  // namespace snug::app
