#include "lesson/still_scene.hpp"

#include <utility>

#include "fit/catalogue.hpp"

namespace snug::lesson {
namespace {

scene::Cloud corners_of(const BoxPair& pair, int box) {
  scene::Cloud corners;
  for (int bits = 0; bits < 1 << pair.dim; ++bits)
    corners.push_back(corner_of(pair, box, bits));
  return corners;
}

scene::Cloud all_of(const AnyPointSet& points) {
  scene::Cloud cloud;
  for (Index i = 0; i < fit::size_of(points); ++i)
    cloud.push_back(fit::point_of(points, i));
  return cloud;
}

}  // namespace

scene::Declaration still_scene(const Lesson& lesson, const AnyPointSet& points) {
  scene::Declaration declaration{.bodies = {}, .effects = {}, .seed = lesson.seed};
  const auto stand = [&](scene::Cloud cloud) {
    scene::Body body;
    body.shape = std::move(cloud);
    body.fixed = true;
    declaration.bodies.push_back(std::move(body));
  };
  if (lesson.boxes)
    for (const int box : {0, 1})
      stand(corners_of(*lesson.boxes, box));
  else
    stand(all_of(points));
  return declaration;
}

}  // namespace snug::lesson
