#include "query/cull/classify_corners.hpp"

#include <doctest/doctest.h>

#include "core/query/exact_planes.hpp"
#include "core/query/grazing.hpp"
#include "measure/random_boxes.hpp"
#include "query/cull/classify.hpp"
#include "query/cull/frustum_sat.hpp"
#include "query/exhibits/wrong_corners_outside.hpp"

using namespace snug;
using query::Culling;

namespace {

template <class Scalar, int Dim>
Obb<Scalar, Dim> box_about(const test::Scene<Scalar, Dim>& scene, Random& random) {
  auto box = test::any_box<Scalar, Dim>(random, 1.6, 0.01, random.below(2) == 0 ? 0.1 : 1.2);
  box.center = (scene.middle + scene.size * box.center.template cast<double>()).template cast<Scalar>();
  box.half_extents *= static_cast<Scalar>(scene.size);
  return box;
}

template <class Scalar, int Dim>
void check_same_as_vertices() {
  Random random(6);
  int counts[3]{};
  for (int round = 0; round < 300; ++round) {
    const auto scene = test::any_scene<Scalar, Dim>(round % test::kFrustumKinds, random);
    for (int i = 0; i < 10; ++i) {
      auto box = box_about(scene, random);
      if (i % 2 == 0) test::graze(scene.frustum[static_cast<int>(random.below(2 * Dim))], box, random);
      Counter slow, quick;
      const auto corners = query::classify_corners(scene.frustum, box, slow);
      const auto vertices = query::classify(scene.frustum, box, {}, quick);
      CHECK(corners.verdict == vertices.verdict);
      CHECK(corners.rejected_by == vertices.rejected_by);
      CHECK(corners.planes_tested == vertices.planes_tested);
      CHECK(corners.crossing == vertices.crossing);
      const auto tests = [](const Counter& counter) {
        return counter.counts[static_cast<std::size_t>(Operation::kOrientationTests)];
      };
      CHECK(tests(slow) == (1 << Dim) * corners.planes_tested);
      CHECK(tests(quick) == 2 * vertices.planes_tested - (vertices.verdict == Culling::kOutside ? 1 : 0));
      // The wrong test never keeps what the right one rejects.
      const Culling wrong = query::corners_outside(scene.frustum, box).verdict;
      if (vertices.verdict == Culling::kOutside) CHECK(wrong == Culling::kOutside);
      CHECK((wrong == Culling::kInside) == (vertices.verdict == Culling::kInside));
      ++counts[static_cast<int>(vertices.verdict)];
    }
  }
  for (const int count : counts) CHECK(count > 50);
}

/// Boxes that cross a frustum with every vertex outside it: the wrong test loses them.
template <class Scalar, int Dim>
void check_counter_example() {
  const auto frustum =
      *frustum_of_camera(FrustumCamera<Scalar, Dim>{.position = Vector<Scalar, Dim>::Ones(), .near = 1, .far = 5});
  Vector<Scalar, Dim> inside = Vector<Scalar, Dim>::Ones();
  inside[Dim - 1] -= 3;
  Random random(1);
  int lost = 0;
  for (int i = 0; i < 250; ++i) {
    Obb<Scalar, Dim> box = cost::random_box<Scalar, Dim>(random);
    box.center = inside + 5 * box.center, box.half_extents *= 5;
    if (query::corners_outside(frustum, box).verdict != Culling::kOutside || !exact::overlap(frustum, box)) continue;
    CHECK(query::classify(frustum, box).verdict == Culling::kIntersecting);
    ++lost;
  }
  CHECK(lost > 0);
}

/// What the planes call intersecting, against the oracle; it agrees with the planes on all else.
template <class Scalar, int Dim>
void check_sat(int wanted) {
  Random random(8);
  int asked = 0, outside = 0, hidden = 0;
  for (int round = 0; asked < wanted; ++round) {
    const auto scene = test::any_scene<Scalar, Dim>(round % test::kFrustumKinds, random);
    const auto sat = query::FrustumSat<Scalar, Dim>::make(scene.frustum);
    REQUIRE(sat.has_value());
    auto box = box_about(scene, random);
    if (round % 5 == 0) box.half_extents[0] = 0;
    if (round % 3 == 0) test::graze(scene.frustum[static_cast<int>(random.below(2 * Dim))], box, random);
    const Culling verdict = query::classify(scene.frustum, box).verdict;
    const bool overlaps = sat->overlaps(box);
    CAPTURE(round);
    if (verdict != Culling::kIntersecting) {
      CHECK(overlaps == (verdict == Culling::kInside));
      outside += verdict == Culling::kOutside;
      continue;
    }
    CHECK(overlaps == exact::overlap(scene.frustum, box));
    ++asked;
    hidden += !overlaps;
  }
  CHECK(outside > 0);
  CHECK(hidden > 0);
  CHECK(hidden < asked / 2);
}

/// One place of a frustum and of a box, a step apart, at them and a step in.
template <class Scalar>
void check_touching_corners() {
  // The left side goes through (-x, 0, -x): a box with an edge on it touches, along no plane of its own.
  const auto frustum = *frustum_of_camera(FrustumCamera<Scalar, 3>{.near = 1, .far = 5});
  const auto sat = *query::FrustumSat<Scalar, 3>::make(frustum);
  const Scalar in = std::nextafter(Scalar(-3), Scalar(0)), out = std::nextafter(Scalar(-3), Scalar(-9));
  CHECK(sat.overlaps(Aabb<Scalar, 3>{{-4, -1, -3}, {-3, 1, -2}}));
  CHECK(sat.overlaps(Aabb<Scalar, 3>{{-4, -1, -3}, {in, 1, -2}}));
  CHECK_FALSE(sat.overlaps(Aabb<Scalar, 3>{{-4, -1, -3}, {out, 1, -2}}));
  // The frustum's own corner at (-5, -5, -5) and a box's.
  CHECK(sat.overlaps(Aabb<Scalar, 3>{{-9, -9, -9}, {-5, -5, -5}}));
  CHECK_FALSE(sat.overlaps(Aabb<Scalar, 3>{{-9, -9, -9}, {-5, -5, std::nextafter(Scalar(-5), Scalar(-9))}}));
}

}  // namespace

TEST_CASE("all corners outside of one plane: the verdict of p- and n-vertex, with four times the work") {
  check_same_as_vertices<double, 3>();
  check_same_as_vertices<float, 3>();
  check_same_as_vertices<double, 2>();
  check_same_as_vertices<float, 2>();
}

TEST_CASE("all corners outside of the frustum: the wrong test loses a box that is found again") {
  check_counter_example<double, 2>();
  check_counter_example<float, 2>();
  check_counter_example<double, 3>();
  check_counter_example<float, 3>();
  // A box that holds all of the frustum has every corner outside.
  const Frustum<double, 3> cube;
  const Aabb<double, 3> large{{-2, -2, -2}, {2, 2, 2}};
  CHECK(query::corners_outside(cube, large).verdict == Culling::kOutside);
  CHECK(query::classify_corners(cube, large).verdict == Culling::kIntersecting);
  CHECK(query::corners_outside(cube, Aabb<double, 3>{{-1, -1, -1}, {1, 1, 1}}).verdict == Culling::kInside);
}

TEST_CASE("steps of the corner tests: eight corners, and the plane that has each outside") {
  const Frustum<double, 3> cube;
  const Aabb<double, 3> box{{0, 0, 0}, {2, 2, 2}};
  query::ClassifyRecorder<double, 3> steps;
  query::corners_outside(cube, box, steps);
  REQUIRE(steps.entries.size() == 9);
  const auto& first = std::get<query::CornerTested<double, 3>>(steps.entries[0].step.fact);
  CHECK(first.plane == -1);
  CHECK_FALSE(first.outside);
  const auto& last = std::get<query::CornerTested<double, 3>>(steps.entries[7].step.fact);
  CHECK(last.corner == 7);
  CHECK(last.plane == 1);
  CHECK(last.distance == 1);
  CHECK(last.point == Vector<double, 3>(2, 2, 2));
  CHECK(last.outside);
  CHECK(std::get<query::Classified>(steps.entries[8].step.fact).result.verdict == Culling::kIntersecting);
}

TEST_CASE("the exact test of frustum and box is that of linear programming") {
  check_sat<double, 2>(200);
  check_sat<float, 2>(200);
  check_sat<double, 3>(20);
  check_sat<float, 3>(20);
}

TEST_CASE("a frustum's edges and corners touch a box's, and a step away do not") {
  check_touching_corners<double>();
  check_touching_corners<float>();
}

TEST_CASE("the exact test of frustum and box takes normals of any length, and corners among the subnormal numbers") {
  const auto check = []<int Dim>(std::integral_constant<int, Dim>, const typename Frustum<double, Dim>::Planes& planes,
                                 const Aabb<double, Dim>& box) {
    const auto frustum = Frustum<double, Dim>::make(planes);
    REQUIRE(frustum.has_value());
    const Obb<double, Dim> turned{(box.min + box.max) / 2, Matrix<double, Dim>::Identity(), (box.max - box.min) / 2};
    CHECK(query::FrustumSat<double, Dim>::make(*frustum)->overlaps(box) == exact::overlap(*frustum, turned));
  };
  const auto in_space = std::integral_constant<int, 3>{};
  const auto in_plane = std::integral_constant<int, 2>{};
  for (const double length : {1.0, 0x1p500, 0x1p-500}) {
    const auto plane = [&](double x, double y, double z, double d) {
      return Plane<double, 3>{Vector<double, 3>(x, y, z) * length, d * length};
    };
    const Frustum<double, 3>::Planes planes{plane(-5, 3, -1, 0), plane(3, -5, -1, 0),  plane(-5, -5, 7, 0),
                                            plane(3, 3, -9, 0),  plane(-1, -1, -1, 3), plane(1, 1, 1, -3e9)};
    for (int i = -6; i <= 6; ++i) check(in_space, planes, Aabb<double, 3>{{8, 6. + i, 6}, {14, 12. + i, 12}});
  }
  // A slab about x = 0 whose sides are tilted by less than a normal number.
  const Frustum<double, 2>::Planes tilted{Plane<double, 2>{{-1.75, 0}, -0x1p-600},
                                          {{1.75, 0}, -0x1p-600},
                                          {{-1.5, -0x1p-1072}, -0x1p-601},
                                          {{1.5, 0x1p-1072}, -0x1p-601}};
  for (int i = -4; i <= 4; ++i)
    check(in_plane, tilted,
          Aabb<double, 2>{{-0x1p-600, std::ldexp(1.0, 470 + i)}, {0x1p-600, std::ldexp(1.5, 470 + i)}});
  constexpr double kLeast = 0x1p-1074;
  const Frustum<double, 2>::Planes tiny{Plane<double, 2>{{-4.7e108, 1.2e108}, -2.3e-215},
                                        {{1, 0}, -3 * kLeast},
                                        {{0, -0.625}, -2 * kLeast},
                                        {{0, 1}, -kLeast}};
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      check(in_plane, tiny, Aabb<double, 2>{{x * kLeast, y * kLeast}, {(x + 2) * kLeast, (y + 2) * kLeast}});
}

TEST_CASE("what the planes do not tell is counted") {
  Random random(2);
  const auto frustum = *frustum_of_camera(FrustumCamera<float, 3>{.near = 1, .far = 9});
  const auto exact = query::FrustumSat<float, 3>::make(frustum).value();
  int intersecting = 0, really_outside = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto box = test::any_box<float, 3>(random, 12, 0.5, 4);
    if (query::classify(frustum, box).verdict != Culling::kIntersecting) continue;
    ++intersecting;
    really_outside += exact.overlaps(box) ? 0 : 1;
  }
  CHECK(really_outside > 20);
  CHECK(really_outside < intersecting / 2);
  const auto endless =
      Frustum<float, 3>::make(
          {{{{1, 0, 0}, 0}, {{1, 0, 0}, 0}, {{1, 0, 0}, 0}, {{1, 0, 0}, 0}, {{1, 0, 0}, 0}, {{1, 0, 0}, 0}}})
          .value();
  CHECK_FALSE(query::FrustumSat<float, 3>::make(endless).has_value());
}
