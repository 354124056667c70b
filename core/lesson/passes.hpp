// What the passes of an iterative run have to beat, and what a question about one must not be told.
#pragma once

#include <optional>

#include "lesson/session.hpp"

namespace snug::lesson {

/// After so many steps: the radius of the best ball that a pass ended with, or of the one that the run started from.
/// Nothing where the trace has no passes.
[[nodiscard]] std::optional<double> best_so_far(Trace trace, int steps);

/// The best radius before the pass that step number `steps` judged; nothing where that step judged none.
[[nodiscard]] std::optional<double> best_before(Trace trace, int steps);

/// Whether the main algorithm's final result is not told: whether a pass comes closer to it is asked.
[[nodiscard]] bool hides_result(const Session& session);

}  // namespace snug::lesson
