// Whether two volumes overlap, for every pair of kinds. Touching volumes do.
// query/overlap/overlap_table.hpp says which test decides which pair.
#pragma once

#include <algorithm>
#include <concepts>
#include <variant>

#include "geometry/volume.hpp"
#include "query/distance/gjk.hpp"
#include "query/overlap/overlap_result.hpp"
#include "query/overlap/overlap_table.hpp"
#include "query/overlap/overlaps_boxes.hpp"
#include "query/overlap/overlaps_slabs.hpp"
#include "query/overlap/overlaps_spheres.hpp"
#include "query/overlap/overlaps_swept.hpp"

namespace snug::query {

/// The answer of GJK. An empty volume overlaps nothing.
template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> result_of(const std::optional<Separation<Scalar, Dim>>& separation) {
  OverlapResult<Scalar, Dim> result;
  if (!separation) return result;
  result.overlap = separation->overlap;
  result.distance = separation->distance;
  result.tests = separation->turns;
  if (!result.overlap) result.separating_axis = {"closest_points", separation->direction, separation->gap};
  return result;
}
template <class A, class B, class Observer>
[[nodiscard]] auto test_gjk(const A& a, const B& b, Observer& observe) {
  return result_of(gjk(a, b, false, observe));
}

/// The verdict of GJK, which stops as soon as it is certain.
template <class A, class B>
[[nodiscard]] bool gjk_overlap(const A& a, const B& b) {
  const auto separation = swapped(a, b) ? gjk(b, a, true) : gjk(a, b, true);
  return separation.has_value() && separation->overlap;
}

/// Tests a and b, which are in the order of the table's rows and columns.
template <class A, class B, class Observer = Ignore>
[[nodiscard]] auto test_in_order(const A& a, const B& b, Observer&& observe = {}) {
  constexpr PairTest kTest = kPairTest<A, B>;
  if constexpr (kTest == PairTest::kSpheres) return test_spheres(a, b, observe);
  else if constexpr (kTest == PairTest::kSphereBox) return test_sphere_box(a, b, observe);
  else if constexpr (kTest == PairTest::kSweptSpheres) return swept_pair(a, b).result(swept_core(a).corner, observe);
  else if constexpr (kTest == PairTest::kSlabs) return test_slabs(a, b, observe);
  else if constexpr (kTest == PairTest::kSeparatingAxes) return test_boxes(a, b, observe);
  else return test_gjk(a, b, observe);
}

/// The verdict alone of a and b, which are in the order of the table's rows and columns.
template <class A, class B>
[[nodiscard, gnu::always_inline]] inline bool overlap_in_order(const A& a, const B& b) {
  constexpr PairTest kTest = kPairTest<A, B>;
  if constexpr (kTest == PairTest::kSpheres) return spheres_overlap(a, b);
  else if constexpr (kTest == PairTest::kSphereBox) return sphere_box_overlap(a, b);
  else if constexpr (kTest == PairTest::kSweptSpheres) return swept_overlap(a, b);
  else if constexpr (kTest == PairTest::kSlabs) return slabs_overlap(a, b);
  else if constexpr (kTest == PairTest::kSeparatingAxes) return boxes_overlap(a, b);
  else return gjk_overlap(a, b);
}

/// Whether they overlap, how far they are apart and along which axis, as far as the pair's test finds it. The error is
/// at most kTouching of both volumes' extents about a common point, wherever that is: closer volumes count as
/// touching. All numbers finite, coordinates at most PointSet's kLargest. The volumes are as their headers say: axes
/// unit and perpendicular within rounding, radii and extents not negative, each min at most its max. The observer
/// receives OverlapStep, SatStep or GjkStep, depending on the pair's test; if the pair is swapped, b is their first
/// volume.
template <template <class, int> class A, template <class, int> class B, class Scalar, int Dim, class Observer = Ignore>
[[nodiscard]] OverlapResult<Scalar, Dim> test_overlap(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b,
                                                      Observer&& observe = {}) {
  constexpr bool kLater = VolumeKind<A<Scalar, Dim>>::kIndex > VolumeKind<B<Scalar, Dim>>::kIndex;
  if constexpr (kLater) return flipped(test_in_order(b, a, observe));
  else if constexpr (!std::is_same_v<A<Scalar, Dim>, B<Scalar, Dim>>) return test_in_order(a, b, observe);
  else return swapped(a, b) ? flipped(test_in_order(b, a, observe)) : test_in_order(a, b, observe);
}

/// The verdict alone, and all that a program has to pay for it. It is that of test_overlap in either order: what
/// rounding cannot change decides most pairs, and the rest goes to exact arithmetic or to the whole test.
template <template <class, int> class A, template <class, int> class B, class Scalar, int Dim>
[[nodiscard, gnu::always_inline]] inline bool overlaps(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b) {
  constexpr bool kLater = VolumeKind<A<Scalar, Dim>>::kIndex > VolumeKind<B<Scalar, Dim>>::kIndex;
  if constexpr (kLater) return overlap_in_order(b, a);
  else return overlap_in_order(a, b);
}

/// The test of any two volumes.
template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> test_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);
template <class Scalar, int Dim>
[[nodiscard]] bool overlaps(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);

}  // namespace snug::query
