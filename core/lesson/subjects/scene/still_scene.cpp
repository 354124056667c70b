#include "lesson/subjects/scene/still_scene.hpp"

#include "fit/catalogue.hpp"
#include "lesson/boxes.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::lesson {

scene::Declaration still_scene(const Subject& subject) {
  scene::Declaration still{.seed = subject.origin().seed};
  const auto add = [&](scene::Cloud cloud) {
    scene::Body body;
    body.fixed = true;
    body.shape = std::move(cloud);
    still.bodies.push_back(std::move(body));
  };
  if (const BoxPair* pair = subject.boxes()) {
    for (const int box : {0, 1}) {
      scene::Cloud vertices;
      for (const Index i : vertices_of(pair->dim, box)) vertices.push_back(subject.at(i));
      add(std::move(vertices));
    }
    return still;
  }
  scene::Cloud points;
  for (Index i = 0; i < subject.size(); ++i) points.push_back(subject.at(i));
  add(std::move(points));
  return still;
}

tl::expected<scene::Declaration, InputError> declared(const Subject& subject, std::string_view method) {
  const auto* scene = as<SceneSubject>(subject);
  if (scene == nullptr) return still_scene(subject);
  return declaration_with(scene->set(), method, *scene->points(), scene->origin().seed);
}

}  // namespace snug::lesson
