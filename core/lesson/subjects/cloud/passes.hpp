// What the passes of an iterative run have to beat.
#pragma once

#include <optional>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// After so many steps: the radius of the best ball that a pass ended with, or of the one that the run started from.
/// Nothing where the trace has no passes.
[[nodiscard]] std::optional<double> best_so_far(FitTrace trace, int steps);

/// The best radius before the pass that step number `steps` judged; nothing where that step judged none.
[[nodiscard]] std::optional<double> best_before(FitTrace trace, int steps);

}  // namespace snug::lesson
