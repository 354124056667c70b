#include "query/cull/batch/classify_batch.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "core/query/grazing.hpp"
#include "query/cull/classify.hpp"

using namespace snug;
using query::Culling;

namespace {

template <class Scalar>
std::array<int, 3> check_batch(const Frustum<Scalar, 3>& frustum, const std::vector<Aabb<Scalar, 3>>& boxes) {
  std::vector<Culling> verdicts(boxes.size() + 1, static_cast<Culling>(7));
  query::classify_all<Scalar>(frustum, query::AabbArray<Scalar>(boxes), std::span(verdicts).first(boxes.size()));
  std::array<int, 3> counts{};
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Culling right = query::classify(frustum, boxes[i]).verdict;
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

}  // namespace

TEST_CASE_TEMPLATE("boxes at once have the verdicts that they have one by one", Scalar, float, double) {
  Random random(1);
  std::array<int, 3> all{};
  for (int round = 0; round < 60; ++round) {
    const auto scene = test::any_scene<Scalar, 3>(round % test::kFrustumKinds, random);
    const bool grazing = round % 2 == 0;
    const auto some = check_batch(scene.frustum, boxes_about(scene, 500, grazing, random));
    for (std::size_t i = 0; i < 3; ++i) all[i] += some[i];
  }
  for (const int count : all) CHECK(count > 200);
}

TEST_CASE_TEMPLATE("none, one, and any number up to more than a block", Scalar, float, double) {
  Random random(2);
  const auto scene = test::any_scene<Scalar, 3>(1, random);
  for (int n = 0; n < 40; ++n) check_batch(scene.frustum, boxes_about(scene, n, false, random));
}

TEST_CASE_TEMPLATE("an array gives back what it was given, and knows how far it reaches", Scalar, float, double) {
  Random random(3);
  const auto scene = test::any_scene<Scalar, 3>(0, random);
  auto boxes = boxes_about(scene, 37, false, random);
  query::AabbArray<Scalar> array(boxes);
  boxes[20] = {{-100, 0, 0}, {1, 2, 3}};
  array.set(20, boxes[20]);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(array[i].min == boxes[i].min);
    CHECK(array[i].max == boxes[i].max);
  }
  CHECK(array.reach()[20 / query::AabbArray<Scalar>::kBlock] == 100);
}

TEST_CASE_TEMPLATE("a wall of cubes around the frustum touches it exactly", Scalar, float, double) {
  std::vector<Aabb<Scalar, 3>> cubes;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z) {
        const Vector<Scalar, 3> center{Scalar(x), Scalar(y), Scalar(z)}, half{Scalar(0.5), Scalar(0.5), Scalar(0.5)};
        cubes.push_back({center - half, center + half});
      }
  const auto of_cubes = check_batch(Frustum<Scalar, 3>(), cubes);
  CHECK(of_cubes == std::array<int, 3>{1, 26, 343 - 27});
}
