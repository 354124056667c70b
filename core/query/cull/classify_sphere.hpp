// Tests a ball against a frustum by its centre alone, with every plane moved out by the radius. A ball is inside by the
// same number with the other sign. The test is classify.hpp's; these are its lines. And a wrong test, kept because it
// is in print: for normals that point out, it moves the planes in.
#pragma once

#include <array>
#include <string_view>

#include "geometry/sphere.hpp"
#include "query/cull/classify.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 6> kClassifySpherePseudocode{
    "crosses ← no",  //
    "for each plane n, d of the frustum",
    "  v ← n · c + d",
    "  outside if v − r > 0",
    "  crosses ← yes if v + r > 0",
    "intersecting if so, else inside",
};
/// The line of kClassifySpherePseudocode that a step of classify belongs to.
[[nodiscard]] constexpr int line_of_sphere(int line) { return line == ClassifyLine::kVerdict ? 5 : line - 1; }

inline constexpr std::array<std::string_view, 4> kWrongSignPseudocode{
    "for each plane n, d of the frustum",
    "  v ← n · c + d",
    "  outside if v + r > 0 (wrong)",
    "inside",
};

/// The answer of the wrong test: a ball is outside if any part of it is outside a plane. It loses every ball that
/// crosses the frustum's boundary. Each plane's step has the true distances. Only the verdict of the result has a
/// meaning. Source: I. D. Romanick, Data Structures & Algorithms for Geometry, 2007, "Sphere in Frustum Test".
template <class Scalar, int Dim, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult wrong_sphere_sign(const Frustum<Scalar, Dim>& frustum, const Sphere<Scalar, Dim>& ball,
                             Observer&& observe = {}) {
  using Step = ClassifyStep<Scalar, Dim>;
  CullResult result;
  for (int at = 0; at < kFrustumPlanes<Dim> && result.verdict != Culling::kOutside; ++at) {
    observe.count(Operation::kOrientationTests, 1);
    ++result.planes_tested;
    const Plane<Scalar, Dim>& plane = frustum[at];
    if (signs_of(plane, ball).high > 0) result.verdict = Culling::kOutside;
    if constexpr (kWatched<Observer>) {
      auto fact = vertices_along(plane, ball);
      const Span<Scalar> span = span_of(plane, ball);
      fact.plane = at;
      fact.p_distance = span.high / length_of(plane);
      fact.n_distance = span.low / length_of(plane);
      fact.doubt = error_bound_of(plane, span_size(ball)) / length_of(plane);
      fact.side = fact.so_far = result.verdict;
      observe(Step{2, fact});
    }
  }
  observe(Step{result.verdict == Culling::kOutside ? 2 : 3, Classified{result}});
  return result;
}

}  // namespace snug::query
