// A tree's culling says of every body what testing that body alone says, and looks at far fewer.
#include "hierarchy/cull.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "geometry/random.hpp"
#include "hierarchy/build.hpp"

using namespace snug;
using query::Culling;

namespace {

using Box = Aabb<double, 3>;

/// Boxes of all sizes up to 1 in a cube from -50 to 50.
std::vector<Box> bodies(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    Vector<double, 3> least, size;
    for (int axis = 0; axis < 3; ++axis) least[axis] = random.between(-50, 50), size[axis] = random.between(0, 1);
    boxes.push_back({least, least + size});
  }
  return boxes;
}

/// A camera at the border that looks inwards, a little to the side.
Frustum<double, 3> view(double sideways) {
  FrustumCamera<double, 3> camera{.position = {sideways, 2, 55}, .near = 0.5, .far = 60};
  camera.half_tangents = {0.6, 0.4};
  return *frustum_of_camera(camera);
}

std::vector<Culling> one_by_one(const std::vector<Box>& boxes, const Frustum<double, 3>& frustum) {
  std::vector<Culling> verdicts;
  for (const Box& box : boxes) verdicts.push_back(query::classify(frustum, box).verdict);
  return verdicts;
}

std::vector<Culling> by_tree(const hierarchy::Tree<Box>& tree, const std::vector<Box>& boxes,
                             const Frustum<double, 3>& frustum, hierarchy::Culled& culled, bool masks = true) {
  std::vector<Culling> verdicts(boxes.size(), Culling::kOutside);
  culled = hierarchy::cull(
      tree, boxes, frustum, [&](Index body, Culling verdict) { verdicts[body] = verdict; }, Ignore(), masks);
  return verdicts;
}

}  // namespace

TEST_CASE("a tree's culling says of every body what testing it alone says") {
  const std::vector<Box> boxes = bodies(3000, 1);
  for (const auto& tree : {hierarchy::build_median<Box>(boxes), hierarchy::build_surface_area<Box>(boxes),
                           hierarchy::build_by_insertion<Box>(boxes)}) {
    for (const double sideways : {0.0, 0.5, -3.0, 40.0}) {
      hierarchy::Culled culled;
      const auto right = one_by_one(boxes, view(sideways));
      CHECK(by_tree(tree, boxes, view(sideways), culled) == right);
      CHECK(by_tree(tree, boxes, view(sideways), culled, false) == right);
      for (const Culling verdict : {Culling::kInside, Culling::kIntersecting, Culling::kOutside})
        CHECK(std::count(right.begin(), right.end(), verdict) > 0);
    }
  }
}

TEST_CASE("culling 20,000 bodies by a tree makes far fewer tests than there are bodies, and masking spares planes") {
  const std::vector<Box> boxes = bodies(20'000, 2);
  const auto tree = hierarchy::build_surface_area<Box>(boxes);
  const auto planes = [&](bool masks) {
    hierarchy::Culled culled;
    by_tree(tree, boxes, view(0.1), culled, masks);
    CHECK(culled.counts.volume_tests() < 20'000 / 3);
    CHECK(culled.counts.volume_tests() > 100);
    return culled.planes_tested;
  };
  CHECK(planes(true) < planes(false));
}

TEST_CASE("a tree without bodies has nothing to cull") {
  const std::vector<Box> none;
  hierarchy::Culled culled;
  CHECK(by_tree(hierarchy::build_median<Box>(none), none, view(0), culled).empty());
  CHECK(culled.counts.nodes_visited == 0);
}
