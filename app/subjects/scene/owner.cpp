#include "app/subjects/scene/owner.hpp"

namespace snug::app {

Owner owner_of(const lesson::SceneSet& scene) {
  Owner owner;
  for (const lesson::SceneBody& one : scene.bodies) {
    owner.of_points = one.of_points, owner.at_points = one.at_points;
    if (one.of_points || one.at_points) return owner;
    ++owner.body;
  }
  return owner;
}

const lesson::SceneBody& declared(const lesson::SceneSet& scene, std::size_t i, std::size_t points) {
  for (const lesson::SceneBody& one : scene.bodies) {
    const std::size_t count = one.at_points ? points : 1;
    if (i < count) return one;
    i -= count;
  }
  return scene.bodies.back();
}

}  // namespace snug::app
