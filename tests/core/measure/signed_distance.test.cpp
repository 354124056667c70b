// The distance and the depth of every pair of volumes: each is proven from both sides, and compared with what is known.
#include "measure/signed_distance.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/query/volume_pairs.hpp"
#include "query/overlap/exact_gap.hpp"
#include "query/overlap/obb_sat.hpp"

using namespace snug;
using namespace snug::test;

namespace {

template <class Scalar, int Dim>
proximity::SignedDistance<Dim> between(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  const auto result = proximity::signed_distance<Scalar, Dim>(a, b);
  REQUIRE(result);
  return *result;
}

/// How far b reaches into a along a direction: moved by that, it lies beyond a plane that a lies before.
template <class Scalar, int Dim>
double depth_along(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, const Vector<double, Dim>& n) {
  return (support_of<Scalar, Dim>(a, n) - support_of<Scalar, Dim>(b, -n)).dot(n);
}

/// Checks what proves the distance or depth: its plane, its ends, and that no other direction does better.
template <class Scalar, int Dim>
void check_proof(VolumeMaker<Scalar, Dim>& maker, const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b,
                 const proximity::SignedDistance<Dim>& found) {
  const double doubt = sizeof(Scalar) == 8 ? 1e-13 : 1e-5;
  CHECK(std::abs(found.direction.norm() - 1) < 1e-12);
  CHECK(std::abs(depth_along<Scalar, Dim>(a, b, found.direction) + found.distance) < doubt);
  CHECK((found.on_b - found.on_a - found.distance * found.direction).norm() < 1e-7);
  for (int i = 0; i < 40; ++i) {
    const Vector<double, Dim> n = maker.direction();
    CHECK(depth_along<Scalar, Dim>(a, b, n) > -found.distance - doubt);
    CHECK((found.on_a - support_of<Scalar, Dim>(a, n)).dot(n) < 1e-6);  // it is a point of a
    CHECK((found.on_b - support_of<Scalar, Dim>(b, n)).dot(n) < 1e-6);
  }
}

template <class Scalar, int Dim>
void check_all_pairs(std::uint64_t seed) {
  VolumeMaker<Scalar, Dim> maker(seed);
  for (std::size_t i = 0; i < kVolumeNames.size(); ++i)
    for (std::size_t j = 0; j < kVolumeNames.size(); ++j)
      for (const Make how : {Make::kSolid, Make::kFlat, Make::kPoint, Make::kLoose})
        for (const double gap : {0.5, 0.0, -0.05, -0.3}) {
          if (gap < 0 && how == Make::kPoint) continue;  // nothing lies inside a point
          const auto a = maker.make(i, how);
          const auto n = maker.direction();
          const auto b = put_at<Scalar, Dim>(a, maker.make(j, maker.random.below(2) == 0 ? how : Make::kSolid), n, gap);
          CAPTURE(kVolumeNames[i]);
          CAPTURE(kVolumeNames[j]);
          CAPTURE(static_cast<int>(how));
          CAPTURE(gap);
          const auto found = between<Scalar, Dim>(a, b);
          check_proof<Scalar, Dim>(maker, a, b, found);
          if (gap >= 0) CHECK(std::abs(found.distance - gap) < (sizeof(Scalar) == 8 ? 1e-12 : 1e-5));
          if (gap < 0 && how == Make::kSolid) CHECK(found.distance < (sizeof(Scalar) == 8 ? 1e-14 : 1e-6));
          const auto turned = between<Scalar, Dim>(b, a);
          CHECK(std::abs(turned.distance - found.distance) < (sizeof(Scalar) == 8 ? 1e-13 : 1e-5));
        }
}

}  // namespace

TEST_CASE("the distance and the depth of every pair of volumes are proven by a plane and by two points") {
  check_all_pairs<double, 2>(1);
  check_all_pairs<double, 3>(2);
  check_all_pairs<float, 2>(3);
  check_all_pairs<float, 3>(4);
  for (std::uint64_t seed = 10; seed < 14; ++seed) check_all_pairs<double, 3>(seed);  // slivers differ by compiler
}

TEST_CASE("two boxes lie as deep in each other as the least overlap of their axes") {
  VolumeMaker<double, 3> maker(5);
  for (int i = 0; i < 300; ++i) {
    const Obb<double, 3> a{maker.any(), maker.axes(), Vector<double, 3>(0.3, 0.6, 1)};
    const Obb<double, 3> b{a.center + maker.any(0.6), maker.axes(), Vector<double, 3>(0.9, 0.2, 0.5)};
    double gap = -std::numeric_limits<double>::infinity();
    for (int place = 0; place < query::kSatAxes<3>; ++place) gap = std::max(gap, query::exact_gap(a, b, place));
    if (gap >= 0) continue;
    CHECK(std::abs(between<double, 3>(a, b).distance - gap) < 1e-14);
  }
}

TEST_CASE("depths that are known are found exactly") {
  using V = Volume<double, 3>;
  const V unit = Aabb<double, 3>{{0, 0, 0}, {1, 1, 1}};
  const auto boxes = between<double, 3>(unit, V(Aabb<double, 3>{{0.75, 0.5, -0.25}, {2, 2, 2}}));
  CHECK(boxes.distance == -0.25);
  CHECK(boxes.direction == Vector<double, 3>(1, 0, 0));
  const auto spheres = between<double, 3>(V(Sphere<double, 3>{{0, 0, 0}, 2}), V(Sphere<double, 3>{{3, 0, 0}, 1.5}));
  CHECK(spheres.distance == -0.5);
  CHECK(spheres.on_a == Vector<double, 3>(2, 0, 0));
  CHECK(spheres.on_b == Vector<double, 3>(1.5, 0, 0));
  const V sphere = Sphere<double, 3>{{1, 2, 3}, 2};
  CHECK(between<double, 3>(sphere, sphere).distance == -4);
  // Parallel capsules that share their axis: they part sideways.
  const auto capsules = between<double, 3>(V(Capsule<double, 3>{{0, 0, 0}, {3, 0, 0}, 1}),
                                           V(Capsule<double, 3>{{1, 0, 0}, {2, 0, 0}, 0.5}));
  CHECK(capsules.distance == -1.5);
  CHECK(capsules.direction[0] == 0);
  // Crossing segments without a radius only touch; those in the plane can lie deep in each other.
  CHECK(between<double, 3>(V(Capsule<double, 3>{{-1, 0, 0}, {1, 0, 0}, 0}),
                           V(Capsule<double, 3>{{0, -1, 0}, {0, 1, 0}, 0}))
            .distance == 0);
  using Flat = Volume<double, 2>;
  CHECK(std::abs(between<double, 2>(Flat(Capsule<double, 2>{{-1, 0}, {1, 0}, 0}),
                                    Flat(Capsule<double, 2>{{0, -1}, {0, 1}, 0}))
                     .distance +
                 1) < 1e-15);
}

TEST_CASE("rounding does not hide how capsules part that are all but parallel") {
  VolumeMaker<double, 3> maker(6);
  for (int i = 0; i < 200; ++i) {
    const Vector<double, 3> along = maker.direction();
    const Volume<double, 3> a = Capsule<double, 3>{{0, 0, 0}, 3 * along, 1};
    const Volume<double, 3> b = Capsule<double, 3>{along, along * 2.1, 0.5};
    const auto found = between<double, 3>(a, b);
    CHECK(std::abs(found.distance + 1.5) < 1e-14);
    CHECK(std::abs(found.direction.dot(along)) < 1e-6);
  }
}

TEST_CASE("depths keep their digits at any scale and far away") {
  VolumeMaker<double, 3> maker(7);
  for (const double scale : {0x1p-330, 1.0, 0x1p330}) {
    const Volume<double, 3> a = Obb<double, 3>{{0, 0, 0}, maker.axes(), {1 * scale, 2 * scale, 3 * scale}};
    const Volume<double, 3> b = Sphere<double, 3>{Vector<double, 3>::Zero(), 0.5 * scale};
    CHECK(std::abs(between<double, 3>(a, b).distance / scale + 1.5) < 1e-14);
  }
  const Volume<double, 3> a = Aabb<double, 3>{{1e8, 1e8, 1e8}, {1e8 + 1, 1e8 + 1, 1e8 + 1}};
  const Volume<double, 3> b = Capsule<double, 3>{{1e8 + 1.25, 1e8 + 0.5, 1e8}, {1e8 + 1.25, 1e8 + 0.5, 1e8 + 1}, 0.5};
  CHECK(between<double, 3>(a, b).distance == -0.25);
}
