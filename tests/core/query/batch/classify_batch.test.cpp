#include "query/batch/classify_batch.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "core/query/grazing.hpp"
#include "query/classify.hpp"

using namespace snug;
using query::Culling;

namespace {

template <class Array, class Scalar, class Shape>
std::array<int, 3> check_batch(const Frustum<Scalar, 3>& frustum, const std::vector<Shape>& shapes) {
  std::vector<Culling> verdicts(shapes.size() + 1, static_cast<Culling>(7));
  query::classify_all<Scalar>(frustum, Array(shapes), std::span(verdicts).first(shapes.size()));
  std::array<int, 3> counts{};
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Culling right = query::classify(frustum, shapes[i]).verdict;
    wrong += verdicts[i] != right;
    ++counts[static_cast<std::size_t>(right)];
  }
  CHECK(wrong == 0);
  CHECK(verdicts.back() == static_cast<Culling>(7));  // nothing is written behind the last
  return counts;
}

template <class Scalar>
std::vector<Aabb<Scalar, 3>> boxes_about(const test::Scene<Scalar, 3>& scene, int n, bool grazing, Random& random) {
  std::vector<Aabb<Scalar, 3>> boxes;
  for (int i = 0; i < n; ++i) {
    const Vector<double, 3> half =
        scene.size * (Vector<double, 3>(0.51, 0.51, 0.51) + test::any_vector<3>(random, 0.5));
    const Vector<double, 3> center = scene.middle + test::any_vector<3>(random, 1.5 * scene.size);
    boxes.push_back({(center - half).template cast<Scalar>(), (center + half).template cast<Scalar>()});
    if (grazing && i % 3 == 0) test::graze(scene.frustum[static_cast<int>(random.below(6))], boxes.back(), random);
  }
  return boxes;
}
template <class Scalar>
std::vector<Sphere<Scalar, 3>> spheres_about(const test::Scene<Scalar, 3>& scene, int n, bool grazing, Random& random) {
  std::vector<Sphere<Scalar, 3>> spheres;
  for (int i = 0; i < n; ++i) {
    const Vector<double, 3> center = scene.middle + test::any_vector<3>(random, 1.5 * scene.size);
    spheres.push_back({center.template cast<Scalar>(), static_cast<Scalar>(random.between(0.01, 0.5) * scene.size)});
    if (grazing && i % 3 == 0) test::graze(scene.frustum[static_cast<int>(random.below(6))], spheres.back(), random);
  }
  return spheres;
}

}  // namespace

TEST_CASE_TEMPLATE("boxes and spheres at once have the verdicts that they have one by one", Scalar, float, double) {
  Random random(1);
  std::array<int, 3> boxes{}, spheres{};
  for (int round = 0; round < 60; ++round) {
    const auto scene = test::any_scene<Scalar, 3>(round % test::kFrustumKinds, random);
    const bool grazing = round % 2 == 0;
    const auto of_boxes =
        check_batch<query::AabbArray<Scalar>>(scene.frustum, boxes_about(scene, 500, grazing, random));
    const auto of_spheres =
        check_batch<query::SphereArray<Scalar>>(scene.frustum, spheres_about(scene, 500, grazing, random));
    for (std::size_t i = 0; i < 3; ++i) boxes[i] += of_boxes[i], spheres[i] += of_spheres[i];
  }
  for (const int count : boxes) CHECK(count > 200);
  for (const int count : spheres) CHECK(count > 200);
}

TEST_CASE_TEMPLATE("none, one, and any number up to more than a block", Scalar, float, double) {
  Random random(2);
  const auto scene = test::any_scene<Scalar, 3>(1, random);
  for (int n = 0; n < 40; ++n) {
    check_batch<query::AabbArray<Scalar>>(scene.frustum, boxes_about(scene, n, false, random));
    check_batch<query::SphereArray<Scalar>>(scene.frustum, spheres_about(scene, n, false, random));
  }
}

TEST_CASE_TEMPLATE("arrays give back what they were given, and know how far it reaches", Scalar, float, double) {
  Random random(3);
  const auto scene = test::any_scene<Scalar, 3>(0, random);
  auto boxes = boxes_about(scene, 37, false, random);
  auto spheres = spheres_about(scene, 37, false, random);
  query::AabbArray<Scalar> box_array(boxes);
  query::SphereArray<Scalar> sphere_array(spheres);
  boxes[20] = {{-100, 0, 0}, {1, 2, 3}}, spheres[20] = {{1, -90, 2}, 20};
  box_array.set(20, boxes[20]), sphere_array.set(20, spheres[20]);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(box_array[i].min == boxes[i].min);
    CHECK(box_array[i].max == boxes[i].max);
    CHECK(sphere_array[i].center == spheres[i].center);
    CHECK(sphere_array[i].radius == spheres[i].radius);
  }
  CHECK(box_array.reach()[20 / query::AabbArray<Scalar>::kBlock] == 100);
  CHECK(sphere_array.reach()[20 / query::SphereArray<Scalar>::kBlock] == 110);
}

TEST_CASE_TEMPLATE("a wall of cubes around the frustum touches it exactly", Scalar, float, double) {
  std::vector<Aabb<Scalar, 3>> cubes;
  std::vector<Sphere<Scalar, 3>> balls;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z) {
        const Vector<Scalar, 3> center{Scalar(x), Scalar(y), Scalar(z)}, half{Scalar(0.5), Scalar(0.5), Scalar(0.5)};
        cubes.push_back({center - half, center + half});
        balls.push_back({center, Scalar(1)});
      }
  const auto of_cubes = check_batch<query::AabbArray<Scalar>>(Frustum<Scalar, 3>(), cubes);
  CHECK(of_cubes == std::array<int, 3>{1, 26, 343 - 27});
  const auto of_balls = check_batch<query::SphereArray<Scalar>>(Frustum<Scalar, 3>(), balls);
  CHECK(of_balls == std::array<int, 3>{1, 124, 343 - 125});
}
