// Tests a box against a frustum by all of its vertices: right, but expensive. A box is outside if all vertices are
// outside one plane. The p- and n-vertex (classify.hpp) give the same answer from two vertices.
#pragma once

#include <array>
#include <string_view>

#include "query/cull/classify_steps.hpp"
#include "query/cull/vertices_along.hpp"
#include "trace/observer.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 6> kClassifyCornersPseudocode{
    "for each plane n, d of the frustum",  //
    "  for each vertex of the box",
    "    is n · vertex + d > 0?",  //
    "  outside if so for all of them",
    "  crosses ← yes if so for some",  //
    "intersecting if crosses, else inside",
};

/// normal . vertex + d, rounded or exact. bits: 1 for +x, 2 for +y, 4 for +z.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Number value_at_corner(const Plane<Scalar, Dim>& plane, const Aabb<Scalar, Dim>& box, int bits) {
  return value_at<Number>(plane, corner_of(box, bits));
}
template <class Number, class Scalar, int Dim>
[[nodiscard]] Number value_at_corner(const Plane<Scalar, Dim>& plane, const Obb<Scalar, Dim>& box, int bits) {
  Number value = value_at<Number>(plane, box.center);
  for (int i = 0; i < Dim; ++i) {
    const Number step = along_axis<Number>(plane, box, i) * exactly<Number>(box.half_extents[i]);
    if ((bits >> i & 1) != 0) value += step;
    else value -= step;
  }
  return value;
}

/// Whether a vertex of the box (of an OBB the exact center + sum +-h_i u_i) is in the positive half-space, exactly.
template <class Scalar, int Dim, class Box>
[[nodiscard]] bool corner_is_outside(const Plane<Scalar, Dim>& plane, const Box& box, int bits) {
  const Scalar value = value_at_corner<Scalar>(plane, box, bits);
  const Scalar error_bound = error_bound_of(plane, magnitude_of(box));
  if (std::abs(value) > error_bound) return value > 0;
  return value_at_corner<Dyadic>(plane, box, bits).sign() > 0;
}

/// The fact that a vertex was tested against a plane.
template <class Scalar, int Dim, class Box>
[[nodiscard]] CornerTested<Scalar, Dim> corner_tested(const Plane<Scalar, Dim>& plane, int at, const Box& box, int bits,
                                                      bool outside) {
  return {bits, at, corner_of(box, bits), value_at_corner<Scalar>(plane, box, bits) / length_of(plane), outside};
}

/// Returns the same verdict as classify. box: an Aabb or an Obb, as in classify. The test ends at the first plane that
/// the box is outside of.
template <class Scalar, int Dim, class Box, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult classify_corners(const Frustum<Scalar, Dim>& frustum, const Box& box, Observer&& observe = {}) {
  using Step = ClassifyStep<Scalar, Dim>;
  CullResult result;
  for (int at = 0; at < kFrustumPlanes<Dim>; ++at) {
    int outside = 0;
    for (int bits = 0; bits < 1 << Dim; ++bits) {
      const bool is_outside = corner_is_outside(frustum[at], box, bits);
      observe.count(Operation::kOrientationTests, 1);
      if constexpr (kWatched<Observer>) observe(Step{2, corner_tested(frustum[at], at, box, bits, is_outside)});
      outside += is_outside ? 1 : 0;
    }
    ++result.planes_tested;
    if (outside == 1 << Dim) {
      result.verdict = Culling::kOutside;
      result.rejected_by = at;
      observe(Step{3, Classified{result}});
      return result;
    }
    if (outside == 0) continue;
    result.verdict = Culling::kIntersecting;
    result.crossing |= PlaneSet{1} << at;
  }
  observe(Step{5, Classified{result}});
  return result;
}

}  // namespace snug::query
