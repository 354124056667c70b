// What merging promises: the result holds both, exactly; is as small as is known to be possible; is the same whichever
// comes first; and is one of the two where that holds the other.
#include "fit/merge/merge.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/exact.hpp"
#include "core/fit/exact_holds.hpp"
#include "core/query/volume_pairs.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/merge/merge_order.hpp"

using namespace snug;
using test::Make;

namespace {

constexpr std::size_t kKinds = 7, kKdopKind = 5, kHullKind = 6;

template <class Scalar, int Dim>
Volume<Scalar, Dim> merged(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return std::visit(
      [&]<class Kind>(const Kind& one) -> Volume<Scalar, Dim> { return fit::merge(one, *std::get_if<Kind>(&b)); }, a);
}

/// Number for number.
template <class Scalar, int Dim>
bool same(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return std::visit([&]<class Kind>(const Kind& one) { return fit::order_of(one, *std::get_if<Kind>(&b)) == 0; }, a);
}

/// Whichever vertex comes first.
template <class Scalar, int Dim>
bool same_but_for_order(Volume<Scalar, Dim> a, Volume<Scalar, Dim> b) {
  const auto sort = [](Volume<Scalar, Dim>& volume) {
    if (auto* hull = std::get_if<ConvexHull<Scalar, Dim>>(&volume))
      std::sort(hull->vertices.begin(), hull->vertices.end(), [](const auto& p, const auto& q) {
        return std::lexicographical_compare(p.data(), p.data() + Dim, q.data(), q.data() + Dim);
      });
  };
  sort(a), sort(b);
  return same(a, b);
}

/// A hull as Quickhull makes it, all others as they are.
template <class Scalar, int Dim>
Volume<Scalar, Dim> proper(const Volume<Scalar, Dim>& volume) {
  const auto* hull = std::get_if<ConvexHull<Scalar, Dim>>(&volume);
  return hull == nullptr ? volume : fit::quickhull(test::set_of<Scalar, Dim>(hull->vertices).span()).volume;
}

template <class Scalar, int Dim>
void check_pair(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  const Volume<Scalar, Dim> both = merged(a, b);
  CHECK(exact::holds(both, a));
  CHECK(exact::holds(both, b));
  CHECK(same_but_for_order(both, merged(b, a)));
  CHECK(same(merged(a, a), a));
}

/// Pairs of a kind of every make, apart by 0 and more, in every size that there is.
template <class Scalar, int Dim>
void check_kind(std::size_t kind) {
  test::VolumeMaker<Scalar, Dim> maker(kind + 10 * Dim);
  const bool is_hull = kind == kHullKind;
  const int tiny = sizeof(Scalar) == 8 ? -1040 : -130, huge = sizeof(Scalar) == 8 ? 480 : 36;
  for (const Make how_a : {Make::kSolid, Make::kFlat, Make::kPoint, Make::kLoose})
    for (const Make how_b : {Make::kSolid, Make::kFlat, Make::kPoint})
      for (const double apart : {0.0, 1e-9, 0.3, 3.0, 1e3, 1e6})
        for (const int size : {0, tiny, huge}) {
          if (size != 0 && apart != (is_hull ? 0.3 : size == tiny ? 3.0 : 1e3)) continue;  // the oracle is slow
          CAPTURE(kind);
          CAPTURE(apart);
          CAPTURE(size);
          CAPTURE(static_cast<int>(how_a));
          CAPTURE(static_cast<int>(how_b));
          Volume<Scalar, Dim> a = maker.make(kind, how_a);
          Volume<Scalar, Dim> b = test::moved<Scalar, Dim>(maker.make(kind, how_b), apart * maker.direction());
          if (auto* kdop = std::get_if<Kdop<Scalar, Dim>>(&a)) {
            // For one k: what remains of two is held by its own test.
            const std::vector<Vector<Scalar, Dim>> cloud{maker.any(), maker.any(), maker.any()};
            *std::get_if<Kdop<Scalar, Dim>>(&b) = maker.kdop_of(kdop->k, cloud);
          }
          const auto scale = static_cast<Scalar>(std::ldexp(1.0, size));
          check_pair(proper(test::scaled<Scalar, Dim>(a, scale)), proper(test::scaled<Scalar, Dim>(b, scale)));
        }
}

/// Both far from the origin, where coordinates have few digits left.
template <class Scalar, int Dim>
void check_far(std::size_t kind) {
  test::VolumeMaker<Scalar, Dim> maker(kind + 10 * Dim);
  for (int i = 0; i < 30; ++i) {
    CAPTURE(kind);
    const Vector<double, Dim> far = maker.direction() * (sizeof(Scalar) == 8 ? 1e14 : 3e5);
    check_pair(proper(test::moved<Scalar, Dim>(maker.make(kind, Make::kSolid), far)),
               proper(test::moved<Scalar, Dim>(maker.make(kind, Make::kSolid), far + 2 * maker.direction())));
  }
}

template <class Scalar, int Dim>
Vector<double, Dim> middle_of(const Volume<Scalar, Dim>& volume) {
  const Vector<Scalar, Dim> origin = Vector<Scalar, Dim>::Zero();
  const auto corners = std::visit([&](const auto& v) { return core_corners(v, origin); }, volume);
  Vector<double, Dim> sum = Vector<double, Dim>::Zero();
  for (const auto& corner : corners) sum += corner;
  return sum / static_cast<double>(corners.size());
}

template <class Scalar, int Dim>
void check_nested(std::size_t kind) {
  test::VolumeMaker<Scalar, Dim> maker(kind + 40 * Dim);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(kind);
    // Solid volumes of a maker reach 0.2 around their middle in every direction.
    const Volume<Scalar, Dim> outer = proper(maker.make(kind, Make::kSolid));
    const Vector<double, Dim> middle =
        kind < kKdopKind ? middle_of(outer) : Vector<double, Dim>(Vector<double, Dim>::Zero());
    Volume<Scalar, Dim> inner =
        test::scaled<Scalar, Dim>(maker.make(kind, i % 2 == 0 ? Make::kSolid : Make::kPoint), Scalar(0x1p-6));
    if (const auto* kdop = std::get_if<Kdop<Scalar, Dim>>(&outer))
      inner = maker.kdop_of(kdop->k, {maker.any(0.01), maker.any(0.01)});
    inner = proper(test::moved<Scalar, Dim>(inner, middle));
    CHECK(same(merged(outer, inner), outer));
    CHECK(same(merged(inner, outer), outer));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("the merged volume holds both", Scalar, float, double) {
  for (std::size_t kind = 0; kind < kHullKind; ++kind) check_kind<Scalar, 2>(kind), check_kind<Scalar, 3>(kind);
}

TEST_CASE_TEMPLATE("the merged hull holds both", Scalar, float, double) {
  check_kind<Scalar, 2>(kHullKind);
  check_far<Scalar, 2>(kHullKind);
  if constexpr (sizeof(Scalar) == 8) check_kind<Scalar, 3>(kHullKind);
}

TEST_CASE_TEMPLATE("the merged volume holds both, far from the origin", Scalar, float, double) {
  for (std::size_t kind = 0; kind < kHullKind; ++kind) check_far<Scalar, 2>(kind), check_far<Scalar, 3>(kind);
}

TEST_CASE_TEMPLATE("a volume that holds the other is the merged one", Scalar, float, double) {
  for (std::size_t kind = 0; kind < kKinds; ++kind) check_nested<Scalar, 2>(kind), check_nested<Scalar, 3>(kind);
}

TEST_CASE_TEMPLATE("two balls merge into the smallest, but for rounding", Scalar, float, double) {
  using exact::Rational;
  constexpr double kRoundoff = tolerance::kRoundoff<Scalar>;
  test::VolumeMaker<Scalar, 3> maker(7);
  int grown = 0;
  for (int i = 0; i < 2000; ++i) {
    const double apart = std::ldexp(1.0, static_cast<int>(maker.random.below(30)) - 10);
    const Sphere<Scalar, 3> a{maker.any(), maker.between(0, 1)}, b{maker.any(apart), maker.between(0, 1)};
    const Sphere<Scalar, 3> both = fit::merge(a, b);
    if (both.radius == a.radius || both.radius == b.radius) continue;
    ++grown;
    // The diameter is at least the distance and both radii.
    const double size = both.center.template cast<double>().cwiseAbs().maxCoeff() + static_cast<double>(both.radius);
    const Rational least = 2 * Rational(static_cast<double>(both.radius)) - Rational(static_cast<double>(a.radius)) -
                           Rational(static_cast<double>(b.radius)) - Rational(16 * kRoundoff * size);
    CHECK(least * least <= exact::squared_distance<Scalar, 3>(a.center, b.center));
  }
  CHECK(grown > 1000);
}

TEST_CASE_TEMPLATE("slabs merge into just their unions", Scalar, float, double) {
  test::VolumeMaker<Scalar, 3> maker(8);
  for (int i = 0; i < 100; ++i) {
    const std::vector<Vector<Scalar, 3>> first{maker.any(), maker.any()}, second{maker.any(), maker.any()};
    const int k = maker.any_k();
    const auto a = maker.kdop_of(k, first), b = maker.kdop_of(k, second);
    auto all = first;
    all.insert(all.end(), second.begin(), second.end());
    CHECK(fit::order_of(fit::merge(a, b), maker.kdop_of(k, all)) == 0);
    const Aabb<Scalar, 3> box_a{first[0].cwiseMin(first[1]), first[0].cwiseMax(first[1])},
        box_b{second[0].cwiseMin(second[1]), second[0].cwiseMax(second[1])};
    const auto box = fit::merge(box_a, box_b);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(box.min[axis] == std::min({all[0][axis], all[1][axis], all[2][axis], all[3][axis]}));
      CHECK(box.max[axis] == std::max({all[0][axis], all[1][axis], all[2][axis], all[3][axis]}));
    }
  }
}

TEST_CASE("k-DOPs of different k keep the slabs that both have") {
  test::VolumeMaker<double, 3> maker(9);
  const std::vector<Vector<double, 3>> cloud{maker.any(), maker.any(), maker.any(), maker.any()};
  for (const int k : {6, 14, 18, 26})
    for (const int other : {6, 14, 18, 26}) {
      const int common = k == other ? k : k == 26 ? other : other == 26 ? k : 6;
      CHECK(fit::order_of(fit::merge(maker.kdop_of(k, cloud), maker.kdop_of(other, cloud)),
                          maker.kdop_of(common, cloud)) == 0);
    }
  test::VolumeMaker<double, 2> flat(9);
  const std::vector<Vector<double, 2>> few{flat.any(), flat.any(), flat.any()};
  for (const int k : {4, 6, 8})
    for (const int other : {4, 6, 8})
      CHECK(fit::order_of(fit::merge(flat.kdop_of(k, few), flat.kdop_of(other, few)),
                          flat.kdop_of(std::min(k, other), few)) == 0);
}

TEST_CASE("boxes, capsules and lozenges end to end merge into what they make up") {
  using Point = Vector<double, 3>;
  const Matrix<double, 3> axes = turn(Point(1, 2, 3).normalized(), 0.7);
  const Point x = axes.col(0), y = axes.col(1);
  const auto size = [](const auto& volume) { return doctest::Approx(measure(volume)).epsilon(1e-12); };

  const Obb<double, 3> box{{1, 2, 3}, axes, {1, 2, 0.5}};
  const Obb<double, 3> next{box.center + 3 * x, axes, {2, 2, 0.5}};
  CHECK(measure(fit::merge(box, next)) == size(Obb<double, 3>{{}, axes, {3, 2, 0.5}}));
  // Two cubes corner to corner: a box along the diagonal of both is smaller than one along the axes of either.
  const Obb<double, 3> cube{{0, 0, 0}, Matrix<double, 3>::Identity(), {1, 1, 1}};
  const Obb<double, 3> far{{20, 20, 20}, Matrix<double, 3>::Identity(), {1, 1, 1}};
  CHECK(measure(fit::merge(cube, far)) < 0.1 * 22 * 22 * 22);

  const Capsule<double, 3> capsule{box.center, box.center + x, 0.25}, on{box.center + 2 * x, box.center + 5 * x, 0.25};
  CHECK(measure(fit::merge(capsule, on)) == size(Capsule<double, 3>{box.center, box.center + 5 * x, 0.25}));
  // A thin one within the thick one's cap: the segment ends where its cap touches.
  const Capsule<double, 3> thin{box.center, box.center + 4 * x, 0.5};
  const Capsule<double, 3> thick{box.center - 3 * x, box.center, 2};
  CHECK(measure(fit::merge(thin, thick)) == size(Capsule<double, 3>{box.center - 3 * x, box.center + 2.5 * x, 2}));
  // Two balls, as capsules.
  const Capsule<double, 3> ball{box.center, box.center, 1}, other{box.center + 4 * y, box.center + 4 * y, 1};
  CHECK(measure(fit::merge(ball, other)) == size(Capsule<double, 3>{box.center, other.a, 1}));

  const Lozenge<double, 3> lozenge{box.center, {Point(2 * x), y}, 0.25},
      beside{box.center + y, {Point(2 * x), Point(3 * y)}, 0.25};
  CHECK(measure(fit::merge(lozenge, beside)) ==
        size(Lozenge<double, 3>{box.center, {Point(2 * x), Point(4 * y)}, 0.25}));
}

TEST_CASE("an empty hull adds nothing") {
  const ConvexHull<double, 2> empty{.affine_dim = -1};
  const ConvexHull<double, 2> point{.vertices = {{1, 2}}, .indices = {0}, .affine_dim = 0};
  CHECK(fit::merge(empty, point).vertices == point.vertices);
  CHECK(fit::merge(point, empty).vertices == point.vertices);
  CHECK(fit::merge(empty, empty).vertices.empty());
}
