// Classifies a volume as inside, outside or intersecting a frustum, plane by plane.
// Source: U. Assarsson, T. Möller, "Optimized View Frustum Culling Algorithms for Bounding Boxes", 2000: p- and
// n-vertex, plane masking, temporal coherence.
//
// All answers are those of exact arithmetic on the numbers as they are, in float as in double: a volume is outside
// exactly if all of it is in one plane's positive half-space, and inside exactly if none of it is in any plane's. So
// nothing that touches the frustum is ever called outside, and nothing that sticks out is called inside. (A kind of
// volume whose header gives a support mapping alone is promised that and no more: within rounding of a plane it is
// called intersecting.) But a volume that is outside the frustum without being outside one plane (near an edge or a
// vertex of the frustum) is called intersecting; for boxes frustum_sat.hpp decides that exactly.
#pragma once

#include <type_traits>

#include "query/cull/classify_steps.hpp"
#include "query/cull/plane_reach.hpp"
#include "query/cull/vertices_along.hpp"
#include "trace/observer.hpp"

namespace snug::query {

/// Whether the test ends at the first plane that the volume is outside of, or tests all planes.
enum class CullExtent : std::uint8_t { kFirst, kAll };

/// What is known about the volume beforehand.
struct CullPlan {
  PlaneSet planes = ~PlaneSet{0};  // to be tested: those that a volume around this one crosses (masking)
  int first = -1;                  // tested first: the one that rejected this volume last time (temporal coherence)
  CullExtent extent = CullExtent::kFirst;
};

/// One test with an observer.
template <class Scalar, int Dim, class Shape, class Observer>
class Classify {
 public:
  Classify(const Frustum<Scalar, Dim>& frustum, const Shape& volume, const CullPlan& plan, Observer& observe)
      : frustum_(frustum), volume_(volume), plan_(plan), observe_(observe), size_(span_size(volume)) {}

  CullResult run() {
    const bool has_first = plan_.first >= 0 && plan_.first < kFrustumPlanes<Dim>;
    bool ended = has_first && test(plan_.first);
    for (int plane = 0; plane < kFrustumPlanes<Dim> && !ended; ++plane)
      if (!has_first || plane != plan_.first) ended = test(plane);
    observe_(Step{result_.verdict == Culling::kOutside ? ClassifyLine::kOutside : ClassifyLine::kVerdict,
                  Classified{result_}});
    return result_;
  }

 private:
  using Step = ClassifyStep<Scalar, Dim>;
  /// A point or a sphere is tested by its centre alone; any other volume by a vertex on either side.
  static constexpr bool kOneVertex =
      std::is_same_v<Shape, Vector<Scalar, Dim>> || std::is_same_v<Shape, Sphere<Scalar, Dim>>;

  struct Sided {
    Culling side;
    bool looked_closer;
  };

  /// Tests one plane. Returns whether the test ends here.
  bool test(int at) {
    if ((plan_.planes >> at & 1) == 0) {
      if constexpr (kWatched<Observer>)
        report({.plane = at, .skipped = true, .so_far = result_.verdict}, ClassifyLine::kSkip);
      return false;
    }
    const Plane<Scalar, Dim>& plane = frustum_[at];
    const Span<Scalar> span = span_of(plane, volume_);
    const Scalar error_bound = error_bound_of(plane, size_);
    const auto [side, looked_closer] = sided(plane, span, error_bound);
    ++result_.planes_tested;
    observe_.count(Operation::kOrientationTests, kOneVertex || side == Culling::kOutside ? 1 : 2);
    if (side == Culling::kIntersecting) result_.crossing |= PlaneSet{1} << at;
    if (side == Culling::kOutside && result_.rejected_by < 0) result_.rejected_by = at;
    if (static_cast<int>(side) > static_cast<int>(result_.verdict)) result_.verdict = side;
    if constexpr (kWatched<Observer>) {
      auto fact = vertices_along(plane, volume_);
      const Scalar length = length_of(plane);
      fact.plane = at;
      fact.p_distance = span.high / length;
      fact.n_distance = span.low / length;
      fact.doubt = error_bound / length;
      fact.looked_closer = looked_closer;
      fact.side = side;
      fact.so_far = result_.verdict;
      report(fact, side == Culling::kOutside ? ClassifyLine::kOutside : ClassifyLine::kIntersects);
    }
    return side == Culling::kOutside && plan_.extent == CullExtent::kFirst;
  }

  /// Decided by rounded numbers where no rounding can change the answer, and exactly otherwise (signs_of).
  [[nodiscard]] Sided sided(const Plane<Scalar, Dim>& plane, const Span<Scalar>& span, Scalar error_bound) const {
    if (span.low > error_bound) return {Culling::kOutside, false};
    if (span.high < -error_bound) return {Culling::kInside, false};
    if (span.low < -error_bound && span.high > error_bound) return {Culling::kIntersecting, false};
    const Span<int> signs = signs_of(plane, volume_);
    Culling side = Culling::kInside;
    if (signs.low > 0) side = Culling::kOutside;
    else if (signs.high > 0) side = Culling::kIntersecting;
    return {side, ReachesExactly<Shape, Plane<Scalar, Dim>>};
  }

  void report(const PlaneTested<Scalar, Dim>& fact, int line) { observe_(Step{line, fact}); }

  const Frustum<Scalar, Dim>& frustum_;
  const Shape& volume_;
  const CullPlan& plan_;
  Observer& observe_;
  Scalar size_;
  CullResult result_;
};

/// volume: a point (Vector), an AabbCenterExtents or any kind of volume; not empty; coordinates finite, no larger than
/// PointSet takes. As exact arithmetic has them, an OBB is all center + sum s_i h_i u_i with |s_i| <= 1 and a lozenge
/// what is near its parallelogram, whether or not their axes and edges are quite perpendicular. Observers count an
/// orientation test for each vertex that is compared with a plane.
template <class Scalar, int Dim, class Shape, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult classify(const Frustum<Scalar, Dim>& frustum, const Shape& volume, const CullPlan& plan = {},
                    Observer&& observe = {}) {
  return Classify<Scalar, Dim, Shape, std::remove_reference_t<Observer>>(frustum, volume, plan, observe).run();
}

/// The same for a volume whose kind is known only at run time.
template <class Scalar, int Dim, StepObserver<ClassifyStep<Scalar, Dim>> Observer = Ignore>
CullResult classify_volume(const Frustum<Scalar, Dim>& frustum, const Volume<Scalar, Dim>& volume,
                           const CullPlan& plan = {}, Observer&& observe = {}) {
  return std::visit([&](const auto& shape) { return classify(frustum, shape, plan, observe); }, volume);
}

// Compiled once, in classify.cpp: without an observer, and with every step kept.
template <class Scalar, int Dim>
using ClassifyRecorder = Recorder<ClassifyStep<Scalar, Dim>>;
#define SNUG_CLASSIFY_SHAPE(EXTERN, Scalar, Dim, Shape)                                                                \
  EXTERN template class Classify<Scalar, Dim, Shape<Scalar, Dim>, Ignore>;                                             \
  EXTERN template class Classify<Scalar, Dim, Shape<Scalar, Dim>, ClassifyRecorder<Scalar, Dim>>;
#define SNUG_CLASSIFY(EXTERN, Scalar, Dim)                                                                             \
  SNUG_CLASSIFY_SHAPE(EXTERN, Scalar, Dim, Vector)                                                                     \
  SNUG_CLASSIFY_SHAPE(EXTERN, Scalar, Dim, AabbCenterExtents)                                                          \
  SNUG_EACH_VOLUME(SNUG_CLASSIFY_SHAPE, EXTERN, Scalar, Dim)
SNUG_CLASSIFY(extern, float, 2)
SNUG_CLASSIFY(extern, float, 3)
SNUG_CLASSIFY(extern, double, 2)
SNUG_CLASSIFY(extern, double, 3)

}  // namespace snug::query
