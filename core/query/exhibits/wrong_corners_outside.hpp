// A wrong test, kept for those who might invent it: a box is outside a frustum if all of its vertices are. It never
// keeps a box that the right test rejects, but it loses boxes that cross the frustum with every vertex outside it, such
// as large ones that contain all of it.
#pragma once

#include <array>
#include <string_view>

#include "query/cull/classify_corners.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 4> kCornersOutsidePseudocode{
    "for each vertex of the box",
    "  is it inside every plane?",
    "inside if all are, intersecting if some are",
    "outside if none is (wrong if the box is wide)",
};

/// The answer of the wrong test. box: an Aabb or an Obb, as for classify. Each vertex's step names the first plane that
/// it is outside of. Only the verdict of the result has a meaning.
template <class Scalar, int Dim, class Box, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult corners_outside(const Frustum<Scalar, Dim>& frustum, const Box& box, Observer&& observe = {}) {
  using Step = ClassifyStep<Scalar, Dim>;
  CullResult result;
  int inside = 0;
  for (int bits = 0; bits < 1 << Dim; ++bits) {
    int rejected_by = -1;
    for (int at = 0; at < kFrustumPlanes<Dim> && rejected_by < 0; ++at) {
      observe.count(Operation::kOrientationTests, 1);
      if (corner_is_outside(frustum[at], box, bits)) rejected_by = at;
    }
    inside += rejected_by < 0 ? 1 : 0;
    if constexpr (kWatched<Observer>) {
      if (rejected_by >= 0) observe(Step{1, corner_tested(frustum[rejected_by], rejected_by, box, bits, true)});
      else observe(Step{1, CornerTested<Scalar, Dim>{.corner = bits, .point = corner_of(box, bits)}});
    }
  }
  result.planes_tested = kFrustumPlanes<Dim>;
  if (inside == 0) result.verdict = Culling::kOutside;
  else result.verdict = inside == 1 << Dim ? Culling::kInside : Culling::kIntersecting;
  observe(Step{inside == 0 ? 3 : 2, Classified{result}});
  return result;
}

}  // namespace snug::query
