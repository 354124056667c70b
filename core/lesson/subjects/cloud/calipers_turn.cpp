#include "lesson/subjects/cloud/calipers_turn.hpp"

#include <algorithm>

namespace snug::lesson {

std::vector<const fit::CalipersTurned<double, 3>*> calipers_turn(FitTrace trace, int steps) {
  std::vector<const fit::CalipersTurned<double, 3>*> turn;
  int i = steps;
  if (i > 0 && std::holds_alternative<fit::RectangleFound<double, 3>>(trace[i - 1].step.fact)) --i;
  while (i-- > 0) {
    const auto* turned = std::get_if<fit::CalipersTurned<double, 3>>(&trace[i].step.fact);
    if (turned == nullptr) break;
    turn.push_back(turned);
  }
  std::reverse(turn.begin(), turn.end());
  return turn;
}

}  // namespace snug::lesson
