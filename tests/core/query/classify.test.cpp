#include "query/cull/classify.hpp"

#include <doctest/doctest.h>

#include "core/query/exact_planes.hpp"
#include "core/query/grazing.hpp"
#include "query/cull/classify_corners.hpp"
#include "query/cull/culler.hpp"

using namespace snug;
using query::Culling;

namespace {

/// A size of any magnitude beside the scene's.
double any_size(double scene, Random& random) {
  return scene * std::ldexp(random.between(0.5, 1), 2 - static_cast<int>(random.below(16)));
}

template <class Scalar, int Dim>
Vector<Scalar, Dim> place(const test::Scene<Scalar, Dim>& scene, Random& random) {
  return (scene.middle + test::any_vector<Dim>(random, 1.5 * scene.size)).template cast<Scalar>();
}

template <class Scalar, int Dim>
void fill(Vector<Scalar, Dim>& point, const test::Scene<Scalar, Dim>& scene, Random& random) {
  point = place(scene, random);
}
template <class Scalar, int Dim>
void fill(Sphere<Scalar, Dim>& sphere, const test::Scene<Scalar, Dim>& scene, Random& random) {
  sphere = {place(scene, random), static_cast<Scalar>(any_size(scene.size, random))};
}
template <class Scalar, int Dim>
void fill(AabbCenterExtents<Scalar, Dim>& box, const test::Scene<Scalar, Dim>& scene, Random& random) {
  box.center = place(scene, random);
  for (int i = 0; i < Dim; ++i)
    box.half_extents[i] = random.below(12) == 0 ? Scalar(0) : static_cast<Scalar>(any_size(scene.size, random));
}
template <class Scalar, int Dim>
void fill(Aabb<Scalar, Dim>& box, const test::Scene<Scalar, Dim>& scene, Random& random) {
  AabbCenterExtents<Scalar, Dim> form;
  fill(form, scene, random);
  box = min_max_of(form);
}
template <class Scalar, int Dim>
void fill(Obb<Scalar, Dim>& box, const test::Scene<Scalar, Dim>& scene, Random& random) {
  AabbCenterExtents<Scalar, Dim> form;
  fill(form, scene, random);
  box = {form.center, test::any_turn<Dim>(random).template cast<Scalar>(), form.half_extents};
}

struct Verdicts {
  int cases = 0, wrong = 0, wrong_outside = 0, wrong_inside = 0, closer = 0;
  int verdicts[3]{};
};

/// Volumes that graze a plane, or do not, against the oracle; each thousandth of them in rationals alone.
template <class Shape, class Scalar, int Dim>
void check_family(int rounds, Verdicts& seen) {
  Random random(5);
  for (int round = 0; round < rounds; ++round) {
    const auto scene = test::any_scene<Scalar, Dim>(round % test::kFrustumKinds, random);
    for (int i = 0; i < 50; ++i) {
      Shape volume;
      fill(volume, scene, random);
      const auto plane = static_cast<int>(random.below(2 * Dim));
      if (random.below(4) != 0) test::graze(scene.frustum[plane], volume, random);
      const auto sum = exact::sum_of(volume);
      const Culling right = exact::classify(scene.frustum, sum, seen.cases % 1000 == 0);
      const Culling verdict = query::classify(scene.frustum, volume).verdict;
      if constexpr (requires { query::Culler<Scalar, Dim>(scene.frustum)(volume); })
        seen.wrong += query::Culler<Scalar, Dim>(scene.frustum)(volume) != right;
      ++seen.cases;
      ++seen.verdicts[static_cast<int>(right)];
      seen.wrong += verdict != right;
      seen.wrong_outside += verdict == Culling::kOutside && right != Culling::kOutside;
      seen.wrong_inside += verdict == Culling::kInside && right != Culling::kInside;
    }
  }
}

void check_all_seen(const Verdicts& seen, int at_least) {
  CHECK(seen.wrong_outside == 0);
  CHECK(seen.wrong_inside == 0);
  CHECK(seen.wrong == 0);
  CHECK(seen.cases >= at_least);
  for (const int count : seen.verdicts) CHECK(count > seen.cases / 20);
}

template <class Scalar>
void check_grazing_spheres() {
  Verdicts seen;
  check_family<Vector<Scalar, 3>, Scalar, 3>(500, seen);
  check_family<Sphere<Scalar, 3>, Scalar, 3>(3000, seen);
  check_family<Sphere<Scalar, 2>, Scalar, 2>(500, seen);
  check_all_seen(seen, 200'000);
}
template <class Scalar>
void check_grazing_boxes() {
  Verdicts seen;
  check_family<Aabb<Scalar, 3>, Scalar, 3>(3000, seen);
  check_family<Aabb<Scalar, 2>, Scalar, 2>(500, seen);
  check_family<AabbCenterExtents<Scalar, 3>, Scalar, 3>(500, seen);
  check_family<Obb<Scalar, 3>, Scalar, 3>(1700, seen);
  check_family<Obb<Scalar, 2>, Scalar, 2>(300, seen);
  check_all_seen(seen, 300'000);
}

}  // namespace

TEST_CASE("a million grazing boxes and spheres are classified as exact arithmetic does: spheres, float") {
  check_grazing_spheres<float>();
}
TEST_CASE("a million grazing boxes and spheres are classified as exact arithmetic does: spheres, double") {
  check_grazing_spheres<double>();
}
TEST_CASE("a million grazing boxes and spheres are classified as exact arithmetic does: boxes, float") {
  check_grazing_boxes<float>();
}
TEST_CASE("a million grazing boxes and spheres are classified as exact arithmetic does: boxes, double") {
  check_grazing_boxes<double>();
}
