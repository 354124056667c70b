// The overlap test of two volumes whose kinds only the running program knows. It is compiled once for each test, and
// not once for each pair of kinds.
#pragma once

#include "query/overlap/overlaps.hpp"

namespace snug::query {

namespace any_pair {

/// Calls a function with the volume, which is of one of these kinds.
template <template <class, int> class... Kinds, class Scalar, int Dim, class Call>
auto among(const Volume<Scalar, Dim>& volume, Call call) {
  OverlapResult<Scalar, Dim> result;
  const auto try_kind = [&](const auto* own) {
    if (own != nullptr) result = call(*own);
    return own != nullptr;
  };
  (try_kind(std::get_if<Kinds<Scalar, Dim>>(&volume)) || ...);
  return result;
}

template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> by_gjk(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                                                Observer& observe, bool only_whether = false) {
  auto [first, second, origin] = cores_of(a, b);
  return result_of(separation_of<Scalar, Dim>(std::move(first), std::move(second), origin, only_whether, observe));
}

template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> by_slabs(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                                                  Observer& observe) {
  return among<Aabb, Kdop>(a, [&](const auto& x) {
    return among<Aabb, Kdop>(b, [&]<class Second>(const Second& y) -> OverlapResult<Scalar, Dim> {
      if constexpr (requires { test_slabs(x, y, observe); }) return test_slabs(x, y, observe);
      else return {};  // a k-DOP before an AABB: cannot happen, the pair is in order
    });
  });
}

/// Tests a and b, which are in the order of the table's rows and columns.
template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> test_any_in_order(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                                                           Observer& observe) {
  using Result = OverlapResult<Scalar, Dim>;
  switch (kPairTests[a.index()][b.index()]) {
    case PairTest::kSpheres:
      return test_spheres(*std::get_if<Sphere<Scalar, Dim>>(&a), *std::get_if<Sphere<Scalar, Dim>>(&b), observe);
    case PairTest::kSphereBox:
      return among<Aabb, Obb>(
          b, [&](const auto& box) { return test_sphere_box(*std::get_if<Sphere<Scalar, Dim>>(&a), box, observe); });
    case PairTest::kSweptSpheres:
      return among<Sphere, Capsule, Lozenge>(a, [&](const auto& x) {
        return among<Capsule, Lozenge>(b, [&](const auto& y) -> Result {
          if constexpr (kCoreDim<std::decay_t<decltype(x)>> <= kCoreDim<std::decay_t<decltype(y)>>)
            return swept_pair(x, y).result(swept_core(x).corner, observe);
          else return {};  // cannot happen, the pair is in order
        });
      });
    case PairTest::kSlabs: return by_slabs(a, b, observe);
    case PairTest::kSeparatingAxes:
      return among<Aabb, Obb>(
          a, [&](const auto& box) { return test_boxes(box, *std::get_if<Obb<Scalar, Dim>>(&b), observe); });
    case PairTest::kSlabsThenGjk:
    case PairTest::kGjk: break;
  }
  return by_gjk(a, b, observe);
}

/// The exact test of two volumes with slabs, in that order too: GJK where no slab separates them. It has no distance,
/// because slabs that separate find none.
template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> by_slabs_then_gjk(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                                                           Observer& observe) {
  const OverlapResult<Scalar, Dim> slabs = by_slabs(a, b, observe);
  if (!slabs.overlap) return slabs;
  OverlapResult<Scalar, Dim> exact = by_gjk(a, b, observe);
  exact.tests += slabs.tests;
  exact.distance.reset();
  return exact;
}

}  // namespace any_pair

/// The same as `swapped` for two volumes of known kinds.
template <class Scalar, int Dim>
[[nodiscard]] bool swapped(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  if (a.index() != b.index()) return a.index() > b.index();
  const Vector<Scalar, Dim> p = anchor_of(a), q = anchor_of(b);
  return std::lexicographical_compare(q.data(), q.data() + q.size(), p.data(), p.data() + p.size());
}

/// The same as test_overlap; the observer receives the same steps.
template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> test_any_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                                                          Observer& observe) {
  if (swapped<Scalar, Dim>(a, b)) return flipped(any_pair::test_any_in_order(b, a, observe));
  return any_pair::test_any_in_order(a, b, observe);
}

/// The test of two volumes of which the pair's own is conservative (is_conservative), exactly: intervals first, then
/// GJK.
template <class Scalar, int Dim, class Observer>
[[nodiscard]] OverlapResult<Scalar, Dim> test_slabs_then_gjk(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                                                             Observer& observe) {
  if (swapped<Scalar, Dim>(a, b)) return flipped(any_pair::by_slabs_then_gjk(b, a, observe));
  return any_pair::by_slabs_then_gjk(a, b, observe);
}

}  // namespace snug::query
