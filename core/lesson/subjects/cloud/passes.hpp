// The radius that the passes of an iterative run have to beat.
#pragma once

#include <optional>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// The best radius after the first `steps` steps: of the balls that passes ended with, or of the one that the run
/// started from. None if the trace has no passes.
[[nodiscard]] std::optional<double> best_so_far(FitTrace trace, int steps);

/// The best radius before the pass that step number `steps` judged; none if that step judged no pass.
[[nodiscard]] std::optional<double> best_before(FitTrace trace, int steps);

}  // namespace snug::lesson
