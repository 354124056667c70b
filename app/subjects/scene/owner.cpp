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

}  // namespace snug::app
