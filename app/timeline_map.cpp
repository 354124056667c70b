#include "app/timeline_map.hpp"

#include <algorithm>
#include <cmath>

namespace snug::app {

float TimelineMap::x_of(int step) const {
  return left + width * static_cast<float>(step) / static_cast<float>(std::max(steps, 1));
}

int TimelineMap::step_at(float x) const {
  const float share = std::clamp((x - left) / std::max(width, 1.0f), 0.0f, 1.0f);
  return static_cast<int>(std::lround(share * static_cast<float>(steps)));
}

std::vector<lesson::Mark> marks_with_room(std::span<const lesson::Mark> marks, const TimelineMap& map, float apart) {
  using Kind = lesson::Mark::Kind;
  std::vector<lesson::Mark> kept;
  std::vector<float> gates;
  for (const lesson::Mark& mark : marks)
    if (mark.kind == Kind::kQuestion) gates.push_back(map.x_of(mark.step));
  float before = -1e9f;
  for (const lesson::Mark& mark : marks) {
    if (mark.kind == Kind::kQuestion) {
      kept.push_back(mark);
      continue;
    }
    const float x = map.x_of(mark.step);
    const bool at_gate = std::any_of(gates.begin(), gates.end(), [&](float gate) { return std::abs(gate - x) < apart; });
    if (x - before < apart || at_gate) continue;
    before = x;
    kept.push_back(mark);
  }
  return kept;
}

}  // namespace snug::app
