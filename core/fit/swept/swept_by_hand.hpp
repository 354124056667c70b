// The sphere-swept volumes whose core is set by hand: a segment or a rectangle.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "fit/swept/capsule_steps.hpp"
#include "fit/swept/lozenge_steps.hpp"
#include "fit/swept/swept_radius.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 3> kCapsuleByHandPseudocode{
    "segment ← set by hand",
    "radius ← to the farthest point, exactly",
    "return capsule",
};

inline constexpr std::array<std::string_view, 3> kLozengeByHandPseudocode{
    "rectangle ← set by hand",
    "radius ← to the farthest point, exactly",
    "return lozenge",
};

/// The volume with the given core, a capsule or a lozenge, and the smallest radius with which it contains every point.
/// core: its radius does not matter. points: n >= 1 finite points, scene units. O(n) time.
template <class StepType, class Scalar, int Dim, StepObserver<StepType> Observer = Ignore>
Fit<typename StepType::Volume> swept_by_hand(PointSpan<Scalar, Dim> points, typename StepType::Volume core,
                                             Observer&& observe = {}) {
  const SweptRadius radius = hold_all(core, points);
  observe.count(Operation::kPointsTouched, points.size());
  observe.count(Operation::kDistanceTests, points.size());
  observe(StepType{1, true, core, RadiusChecked{radius.farthest, radius.widened}});
  const double size = swept_size(core, points);
  std::vector<Index> support;
  for (Index i = 0; i < points.size(); ++i)
    if (touches(core, points[i], size)) support.push_back(i);
  observe(StepType{2, true, core, Finished{support}});
  return {core, std::move(support)};
}

}  // namespace snug::fit
