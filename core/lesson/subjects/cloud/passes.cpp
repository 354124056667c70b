#include "lesson/subjects/cloud/passes.hpp"

namespace snug::lesson {

using fit::PassJudged;

std::optional<double> best_so_far(FitTrace trace, int steps) {
  for (int i = steps; i-- > 0;) {
    const fit::Step3& step = trace[i].step;
    if (const auto* pass = std::get_if<PassJudged<double, 3>>(&step.fact)) return pass->best.radius;
    // Finished at the start, not at the end: the ball that the passes begin with.
    const bool starts = std::holds_alternative<fit::Finished>(step.fact) && i + 1 < static_cast<int>(trace.size());
    if (starts && ball_of(step) != nullptr) return ball_of(step)->radius;
  }
  return std::nullopt;
}

std::optional<double> best_before(FitTrace trace, int steps) {
  if (steps == 0 || !std::holds_alternative<PassJudged<double, 3>>(trace[steps - 1].step.fact)) return std::nullopt;
  return best_so_far(trace, steps - 1);
}

}  // namespace snug::lesson
