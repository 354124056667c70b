// Whether two volumes overlap, for every pair of kinds. Touching volumes do.
// query/overlap_table.hpp says which test decides which pair.
#pragma once

#include <algorithm>
#include <concepts>
#include <variant>

#include "geometry/volume.hpp"
#include "query/gjk.hpp"
#include "query/overlap_result.hpp"
#include "query/overlap_table.hpp"
#include "query/overlaps_boxes.hpp"
#include "query/overlaps_slabs.hpp"
#include "query/overlaps_spheres.hpp"
#include "query/overlaps_swept.hpp"

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

/// The result of GJK after slabs that did not separate. It has no distance, because slabs that separate find
/// none.
template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> after_slabs(const OverlapResult<Scalar, Dim>& slabs,
                                                     OverlapResult<Scalar, Dim> settled) {
  settled.tests += slabs.tests;
  settled.distance.reset();
  return settled;
}

/// Tests the slabs that both share, then GJK if those do not separate.
template <class A, class B, class Observer>
[[nodiscard]] auto test_slabs_then_gjk(const A& a, const B& b, Observer& observe) {
  const auto result = test_slabs(a, b, observe);
  return result.overlap ? after_slabs(result, test_gjk(a, b, observe)) : result;
}

/// Tests a and b, which are in the order of the table's rows and columns.
template <class A, class B, class Observer = Ignore>
[[nodiscard]] auto test_in_order(const A& a, const B& b, Observer&& observe = {}) {
  constexpr PairTest kTest = kPairTest<A, B>;
  if constexpr (kTest == PairTest::kSpheres) return test_spheres(a, b, observe);
  else if constexpr (kTest == PairTest::kSphereBox) return test_sphere_box(a, b, observe);
  else if constexpr (kTest == PairTest::kSweptSpheres) return swept_pair(a, b).result(swept_core(a).corner, observe);
  else if constexpr (kTest == PairTest::kSlabs) return test_slabs(a, b, observe);
  else if constexpr (kTest == PairTest::kSlabsThenGjk) return test_slabs_then_gjk(a, b, observe);
  else if constexpr (kTest == PairTest::kSeparatingAxes) return test_boxes(a, b, observe);
  else return test_gjk(a, b, observe);
}

/// Only the verdict, which is cheaper for some pairs.
template <class A, class B>
[[nodiscard]] bool overlap_in_order(const A& a, const B& b) {
  constexpr PairTest kTest = kPairTest<A, B>;
  if constexpr (kTest == PairTest::kSweptSpheres) {
    return !swept_pair(a, b).apart();
  } else if constexpr (kTest == PairTest::kGjk) {
    const auto separation = gjk(a, b, true);
    return separation && separation->overlap;
  } else {
    return test_in_order(a, b).overlap;
  }
}

/// Whether the test takes b first. Kinds are ordered as in the table, and volumes of one kind by their anchors, so that
/// a pair has the same answer in either order. (Two of a kind with the same anchor overlap in either order.)
template <class A, class B>
[[nodiscard]] bool turned(const A& a, const B& b) {
  if constexpr (!std::is_same_v<A, B>) return VolumeKind<A>::kIndex > VolumeKind<B>::kIndex;
  const auto p = anchor(a);
  const auto q = anchor(b);
  return std::lexicographical_compare(q.data(), q.data() + q.size(), p.data(), p.data() + p.size());
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
  else return turned(a, b) ? flipped(test_in_order(b, a, observe)) : test_in_order(a, b, observe);
}

/// Only the verdict, which is cheaper for some pairs.
template <template <class, int> class A, template <class, int> class B, class Scalar, int Dim>
[[nodiscard]] bool overlaps(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b) {
  constexpr bool kLater = VolumeKind<A<Scalar, Dim>>::kIndex > VolumeKind<B<Scalar, Dim>>::kIndex;
  if constexpr (kLater) return overlap_in_order(b, a);
  else if constexpr (!std::is_same_v<A<Scalar, Dim>, B<Scalar, Dim>>) return overlap_in_order(a, b);
  else return turned(a, b) ? overlap_in_order(b, a) : overlap_in_order(a, b);
}

/// The test of any two volumes.
template <class Scalar, int Dim>
[[nodiscard]] OverlapResult<Scalar, Dim> test_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);
template <class Scalar, int Dim>
[[nodiscard]] bool overlaps(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);

template <class A, class B>
concept Testable = requires(const A& a, const B& b) {
  { test_overlap(a, b).overlap } -> std::convertible_to<bool>;
  { overlaps(a, b) } -> std::same_as<bool>;
};

namespace pair_table {

/// Whether each of these volumes can be tested against each.
template <class... Kinds>
constexpr bool are_all_testable(const std::variant<Kinds...>*) {
  const auto with_each = []<class A>(const A*) { return (Testable<A, Kinds> && ...); };
  return (with_each(static_cast<const Kinds*>(nullptr)) && ...);
}

}  // namespace pair_table

static_assert(pair_table::are_all_testable(static_cast<const Volume<double, 2>*>(nullptr)));
static_assert(pair_table::are_all_testable(static_cast<const Volume<double, 3>*>(nullptr)));
static_assert(pair_table::are_all_testable(static_cast<const Volume<float, 2>*>(nullptr)));
static_assert(pair_table::are_all_testable(static_cast<const Volume<float, 3>*>(nullptr)));

}  // namespace snug::query
