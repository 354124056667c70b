#include "lesson/still_scene.hpp"

#include <utility>

namespace snug::lesson {
namespace {

SceneBody still_body() {
  SceneBody still;
  still.body.fixed = true;
  return still;
}

SceneBody corners_of(const BoxPair& pair, int box) {
  SceneBody still = still_body();
  scene::Cloud corners;
  for (int bits = 0; bits < 1 << pair.dim; ++bits) corners.push_back(corner_of(pair, box, bits));
  still.body.shape = std::move(corners);
  return still;
}

}  // namespace

SceneSet still_scene(const Lesson& lesson) {
  SceneSet set;
  if (lesson.boxes) {
    set.bodies = {corners_of(*lesson.boxes, 0), corners_of(*lesson.boxes, 1)};
  } else {
    set.bodies = {still_body()};
    set.bodies.front().of_points = true;
  }
  return set;
}

}  // namespace snug::lesson
