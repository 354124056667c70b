#include <doctest/doctest.h>

#include "core/query/exact_planes.hpp"
#include "core/query/grazing.hpp"
#include "fit/hull/quickhull.hpp"
#include "query/cull/classify.hpp"

using namespace snug;
using query::Culling;

namespace {

std::int64_t tests(const OperationCounts& counts) {
  return counts[static_cast<std::size_t>(Operation::kOrientationTests)];
}

/// A point about the scene, on a coarse grid where it is upright, so that it meets planes exactly.
template <class Scalar, int Dim>
Vector<Scalar, Dim> somewhere(const test::Scene<Scalar, Dim>& scene, Random& random) {
  Vector<double, Dim> offset = test::any_vector<Dim>(random, 1.4);
  for (int i = 0; i < Dim; ++i) offset[i] = std::round(offset[i] * 16) / 16;
  return (scene.middle + scene.size * offset).template cast<Scalar>();
}

template <class Scalar, int Dim>
Kdop<Scalar, Dim> kdop_of(int k, const std::vector<Vector<Scalar, Dim>>& points) {
  Kdop<Scalar, Dim> kdop{.k = k};
  const auto axes = kdop_axes<Dim>(k);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto along = [&](const Vector<Scalar, Dim>& p) {
      Scalar sum = 0;
      for (std::size_t i = 0; i < Dim; ++i) sum += static_cast<Scalar>(axes[a][i]) * p[static_cast<int>(i)];
      return sum;
    };
    kdop.min[a] = kdop.max[a] = along(points[0]);
    for (const auto& p : points)
      kdop.min[a] = std::min(kdop.min[a], along(p)), kdop.max[a] = std::max(kdop.max[a], along(p));
  }
  return kdop;
}

struct KindTally {
  int verdicts[3]{};
  void check(int least) const {
    for (const int count : verdicts) CHECK(count >= least);
  }
};

template <class Scalar, int Dim>
void check_kind(const test::Scene<Scalar, Dim>& scene, const auto& volume, Culling right, KindTally& tally) {
  CHECK(query::classify(scene.frustum, volume).verdict == right);
  CHECK(query::classify_volume(scene.frustum, Volume<Scalar, Dim>(volume)).verdict == right);
  ++tally.verdicts[static_cast<int>(right)];
}

template <class Scalar, int Dim>
void check_all_kinds() {
  Random random(4);
  KindTally capsules, lozenges, hulls, kdops;
  const std::vector<int> ks = Dim == 2 ? std::vector{4, 6, 8} : std::vector{6, 14, 18};
  for (int round = 0; round < 144; ++round) {
    const auto scene = test::any_scene<Scalar, Dim>(round % test::kFrustumKinds, random);
    const auto plane = static_cast<int>(random.below(2 * Dim));
    const bool grazing = round % 4 != 0;
    const auto radius = static_cast<Scalar>(scene.size * random.between(0.01, 0.4));

    Capsule<Scalar, Dim> capsule{somewhere(scene, random), somewhere(scene, random), radius};
    if (round % 3 == 0) capsule.b = capsule.a + (capsule.b - capsule.a) / 16;
    if (grazing) test::graze(scene.frustum[plane], capsule, random);
    check_kind(scene, capsule, exact::classify(scene.frustum, capsule), capsules);

    const auto axes = test::any_turn<Dim>(random);
    Lozenge<Scalar, Dim> lozenge{somewhere(scene, random)};
    for (std::size_t i = 0; i < 2; ++i)
      lozenge.edges[i] =
          (axes.col(static_cast<int>(i)) * scene.size * random.between(-0.5, 0.5)).template cast<Scalar>();
    lozenge.radius = radius;
    if (grazing) test::graze(scene.frustum[plane], lozenge, random);
    check_kind(scene, lozenge, exact::classify(scene.frustum, exact::sum_of(lozenge), true), lozenges);

    std::vector<Vector<Scalar, Dim>> points;
    const auto about = somewhere(scene, random);
    for (int i = 0; i < 6; ++i) points.push_back(about + (somewhere(scene, random) - about) / Scalar(8));
    if (grazing) {  // all moved so that the first one grazes
      const Vector<Scalar, Dim> before = points[0];
      test::graze(scene.frustum[plane], points[0], random);
      for (std::size_t i = 1; i < points.size(); ++i) points[i] += points[0] - before;
    }
    const auto hull = fit::quickhull(PointSet<Scalar, Dim>::make(points)->span()).volume;
    check_kind(scene, hull, exact::classify(scene.frustum, points), hulls);

    if (round % 12 > 1) continue;
    const auto kdop = kdop_of<Scalar, Dim>(ks[round % 36 == 0 ? 2 : round % 2], points);
    check_kind(scene, kdop, exact::classify(scene.frustum, kdop), kdops);
  }
  capsules.check(3), lozenges.check(3), hulls.check(3), kdops.check(1);
}

/// The numbers that never round: those of a k-DOP times 12.
template <class Scalar, int Dim, class Shape>
void check_doubt(const Plane<Scalar, Dim>& plane, const Shape& volume, int times, double& most) {
  const auto rounded = query::span_of(plane, volume);
  const auto exact = core_span<Dyadic>(plane, volume);
  const auto doubt = static_cast<double>(query::error_bound_of(plane, magnitude_of(volume)));
  const auto off = [&](Scalar own, const Dyadic& right) {
    const double error = std::abs((Dyadic(static_cast<double>(own)) * Dyadic(times) - right).approximate()) / times;
    CHECK(error <= doubt);
    most = std::max(most, error / doubt);
  };
  off(rounded.low, exact.low);
  off(rounded.high, exact.high);
}

template <class Scalar>
void check_doubts() {
  Random random(3);
  double boxes = 0, kdops = 0;
  for (int round = 0; round < 600; ++round) {
    const auto scene = test::any_scene<Scalar, 3>(round % test::kFrustumKinds, random);
    const auto& plane = scene.frustum[static_cast<int>(random.below(6))];
    auto box = test::any_box<Scalar, 3>(random, 1, 0.01, 1);
    box.center = (scene.middle + scene.size * box.center.template cast<double>()).template cast<Scalar>();
    box.half_extents *= static_cast<Scalar>(scene.size);
    test::graze(plane, box, random);
    check_doubt(plane, box, 1, boxes);
    check_doubt(plane, AabbCenterExtents<Scalar, 3>{box.center, box.half_extents}, 1, boxes);
    check_doubt(plane, Aabb<Scalar, 3>{box.center, box.center + box.half_extents}, 1, boxes);
    if (round % 10 != 0) continue;
    std::vector<Vector<Scalar, 3>> points;
    for (int i = 0; i < 8; ++i)
      points.push_back(box.center + (test::any_vector<3>(random) * scene.size).template cast<Scalar>());
    check_doubt(plane, kdop_of<Scalar, 3>(26, points), 12, kdops);
  }
  // Not so wide that everything would be looked at exactly.
  CHECK(boxes > 1.0 / 32);
  CHECK(kdops > 1.0 / 1024);
}

}  // namespace

TEST_CASE("capsules, lozenges, hulls and k-DOPs are classified as exact arithmetic does") {
  check_all_kinds<double, 3>();
  check_all_kinds<float, 3>();
  check_all_kinds<double, 2>();
  check_all_kinds<float, 2>();
}

TEST_CASE("the rounded reach stays within its error bound") {
  check_doubts<float>();
  check_doubts<double>();
}

TEST_CASE("touching from outside is intersecting, from inside inside; one step farther is not") {
  const Frustum<float, 3> cube;
  const auto of = [&](const auto& volume) { return query::classify(cube, volume).verdict; };
  const float above = std::nextafter(1.0f, 2.0f);
  CHECK(of(Vector<float, 3>(1, -1, 0)) == Culling::kInside);
  CHECK(of(Vector<float, 3>(above, 0, 0)) == Culling::kOutside);
  CHECK(of(Sphere<float, 3>{{2, 0, 0}, 1}) == Culling::kIntersecting);
  CHECK(of(Sphere<float, 3>{{std::nextafter(2.0f, 3.0f), 0, 0}, 1}) == Culling::kOutside);
  CHECK(of(Sphere<float, 3>{{0, 0, 0}, 1}) == Culling::kInside);
  CHECK(of(Sphere<float, 3>{{0, 0, 0}, above}) == Culling::kIntersecting);
  CHECK(of(Sphere<float, 3>{{1e-40f, 0, 0}, 1}) == Culling::kIntersecting);  // beneath every rounding
  CHECK(of(Aabb<float, 3>{{1, -9, -9}, {2, 9, 9}}) == Culling::kIntersecting);
  CHECK(of(Aabb<float, 3>{{above, -9, -9}, {2, 9, 9}}) == Culling::kOutside);
  CHECK(of(Aabb<float, 3>{{-1, -1, -1}, {1, 1, 1}}) == Culling::kInside);
  CHECK(of(Kdop<float, 3>{.k = 6, .min = {-1, -1, -1}, .max = {1, 1, 1}}) == Culling::kInside);
  CHECK(of(Kdop<float, 3>{.k = 6, .min = {-1, -1, -1}, .max = {1, 1, above}}) == Culling::kIntersecting);
  CHECK(of(Kdop<float, 3>{.k = 6, .min = {above, -1, -1}, .max = {2, 1, 1}}) == Culling::kOutside);
}

TEST_CASE("near a frustum's edge the planes do not tell: outside of none, and called intersecting") {
  const auto frustum = *frustum_of_camera(FrustumCamera<double, 2>{.near = 1, .far = 8});
  // Beside the corner at (-8, -8): outside, but not of the far line alone nor of the left one.
  const Obb<double, 2> box{{-9.5, -8}, Matrix<double, 2>::Identity(), {1, 2}};
  CHECK(query::classify(frustum, box).verdict == Culling::kIntersecting);
  CHECK_FALSE(exact::overlap(frustum, box));
}

TEST_CASE("the steps say signs, corners, distances, side and the verdict so far") {
  const Frustum<double, 3> cube;
  Obb<double, 3> box{{1.5, 0, 0}, Matrix<double, 3>::Identity(), {1, 0.25, 0.5}};
  box.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // its x is the world's y, its y the world's -x
  query::ClassifyRecorder<double, 3> steps;
  const auto result = query::classify(cube, box, {}, steps);
  CHECK(result.verdict == Culling::kOutside);
  CHECK(result.rejected_by == 1);
  REQUIRE(steps.entries.size() == 3);
  const auto& left = std::get<query::PlaneTested<double, 3>>(steps.entries[0].step.fact);
  CHECK(steps.entries[0].step.line == query::ClassifyLine::kIntersects);
  CHECK(left.side == Culling::kInside);
  CHECK(left.so_far == Culling::kInside);
  const auto& right = std::get<query::PlaneTested<double, 3>>(steps.entries[1].step.fact);
  CHECK(steps.entries[1].step.line == query::ClassifyLine::kOutside);
  CHECK(right.plane == 1);
  CHECK(right.normal == Vector<double, 3>(0, -1, 0));
  CHECK(right.signs == 0b101);
  CHECK(right.p_vertex == 0b101);
  CHECK(right.n_vertex == 0b010);
  CHECK(right.p_point == Vector<double, 3>(1.75, 1, 0.5));
  CHECK(right.n_point == Vector<double, 3>(1.25, -1, -0.5));
  CHECK(right.p_distance == 0.75);
  CHECK(right.n_distance == 0.25);
  CHECK(right.side == Culling::kOutside);
  CHECK(right.so_far == Culling::kOutside);
  CHECK_FALSE(right.looked_closer);
  CHECK(std::get<query::Classified>(steps.entries[2].step.fact).result.rejected_by == 1);
  CHECK(tests(steps.counts) == 3);  // two vertices, then the one that rejects

  // Distances are in scene units whatever the normals' lengths, and what touches is looked at exactly.
  auto planes = cube.planes();
  planes[1] = {{4, 0, 0}, -4};
  query::ClassifyRecorder<double, 3> again;
  query::classify(*Frustum<double, 3>::make(planes), Sphere<double, 3>{{1.5, 0, 0}, 0.5}, {}, again);
  const auto& touched = std::get<query::PlaneTested<double, 3>>(again.entries[1].step.fact);
  CHECK(touched.n_distance == 0);
  CHECK(touched.p_distance == 1);
  CHECK(touched.looked_closer);
  CHECK(touched.p_vertex == -1);
  CHECK(touched.p_point == Vector<double, 3>(2, 0, 0));
  CHECK(again.entries.size() == 7);
}

TEST_CASE("all planes on demand: the verdict and the first that rejects stay") {
  const Frustum<double, 2> square;
  const Aabb<double, 2> box{{2, 2}, {3, 3}};
  query::ClassifyRecorder<double, 2> steps;
  const auto all = query::classify(square, box, {.extent = query::CullExtent::kAll}, steps);
  CHECK(steps.entries.size() == 5);
  CHECK(all.planes_tested == 4);
  CHECK(all.verdict == Culling::kOutside);
  CHECK(all.rejected_by == 1);
  CHECK(query::classify(square, box).rejected_by == 1);
}

TEST_CASE("masking: a child skips the planes that its parent is inside of, and has the same verdict") {
  Random random(7);
  std::int64_t with = 0, without = 0;
  int skipped = 0;
  for (int round = 0; round < 2000; ++round) {
    const auto scene = test::any_scene<double, 3>(round % test::kFrustumKinds, random);
    auto parent = test::any_box<double, 3>(random, 1.2, 0.1, 0.9);
    parent.center = scene.middle + scene.size * parent.center, parent.half_extents *= scene.size;
    const auto above = query::classify(scene.frustum, parent);
    if (above.verdict == Culling::kOutside) continue;
    // A child with its parent's axes, well inside it.
    Obb<double, 3> child{parent.center +
                             parent.axes * parent.half_extents.cwiseProduct(test::any_vector<3>(random, 0.7)),
                         parent.axes, parent.half_extents / 4};
    Recorder<query::ClassifyStep<double, 3>> masked;
    Counter all;
    const auto result = query::classify(scene.frustum, child, {.planes = above.crossing}, masked);
    const auto right = query::classify(scene.frustum, child, {}, all);
    CHECK(result.verdict == right.verdict);
    CHECK((result.crossing & ~above.crossing) == 0);
    if (result.verdict != Culling::kOutside) CHECK(result.crossing == right.crossing);
    with += tests(masked.counts), without += tests(all.counts);
    for (const auto& entry : masked.entries)
      if (const auto* fact = std::get_if<query::PlaneTested<double, 3>>(&entry.step.fact)) {
        CHECK(fact->skipped == ((above.crossing >> fact->plane & 1) == 0));
        skipped += fact->skipped;
      }
  }
  CHECK(skipped > 1000);
  CHECK(with * 2 < without);
}

TEST_CASE("temporal coherence: the plane that rejected last time goes first, and the verdict is the same") {
  Random random(8);
  std::int64_t with = 0, without = 0;
  for (int round = 0; round < 500; ++round) {
    const auto scene = test::any_scene<double, 3>(round % test::kFrustumKinds, random);
    Sphere<double, 3> sphere{scene.middle + test::any_vector<3>(random, 1.8 * scene.size), 0.1 * scene.size};
    int last = -1;
    for (int frame = 0; frame < 10; ++frame) {
      Counter first, usual;
      const auto result = query::classify(scene.frustum, sphere, {.first = last}, first);
      const auto right = query::classify(scene.frustum, sphere, {}, usual);
      CHECK(result.verdict == right.verdict);
      if (last >= 0 && result.rejected_by == last) CHECK(result.planes_tested == 1);
      with += tests(first.counts), without += tests(usual.counts);
      last = result.rejected_by;
      sphere.center += test::any_vector<3>(random, 0.02 * scene.size);
    }
  }
  CHECK(with * 4 < without * 3);
  // A plane that is masked is skipped, first or not; one that there is not is no matter.
  const Sphere<double, 3> right_of{{5, 0, 0}, 1};
  CHECK(query::classify(Frustum<double, 3>(), right_of, {.planes = 0b1, .first = 1}).verdict == Culling::kInside);
  CHECK(query::classify(Frustum<double, 3>(), right_of, {.first = 6}).rejected_by == 1);
}
