#include "app/picking.hpp"

#include <cmath>

namespace snug::app {

Index pick(std::span<const ScreenPoint> points, float x, float y, float reach) {
  Index best = kNoIndex;
  float nearest = reach;
  float depth = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ScreenPoint& point = points[i];
    if (!point.visible) continue;
    const float distance = std::hypot(point.x - x, point.y - y);
    if (distance > reach) continue;
    const bool as_near = best != kNoIndex && std::abs(distance - nearest) < 1;
    if (best == kNoIndex || (as_near ? point.depth < depth : distance < nearest)) {
      best = static_cast<Index>(i);
      nearest = distance;
      depth = point.depth;
    }
  }
  return best;
}

Index grab(std::span<const ScreenPoint> points, bool space, Index selected, float x, float y, bool finger) {
  if (!space || points.size() <= static_cast<std::size_t>(kSparse))
    return pick(points, x, y, finger ? kFingerReach : kMouseReach);
  if (selected >= 0 && static_cast<std::size_t>(selected) < points.size()) {
    const auto only = points.subspan(selected, 1);
    if (pick(only, x, y, finger ? kFingerReach : kSelectedReach) == 0) return selected;
  }
  return finger ? kNoIndex : pick(points, x, y, kExactReach);
}

}  // namespace snug::app
