#include "lesson/subjects/scene/still_scene.hpp"

#include "fit/catalogue.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::lesson {

scene::Declaration still_scene(const Subject& subject) {
  scene::Declaration still{.seed = subject.origin().seed};
  for (const std::vector<Index>& thing : subject.things()) {
    scene::Body body;
    body.fixed = true;
    scene::Cloud points;
    for (const Index i : thing) points.push_back(subject.at(i));
    body.shape = std::move(points);
    still.bodies.push_back(std::move(body));
  }
  return still;
}

tl::expected<scene::Declaration, InputError> declared(const Subject& subject, std::string_view method) {
  const auto* scene = as<SceneSubject>(subject);
  if (scene == nullptr) return still_scene(subject);
  return declaration_with(scene->set(), method, *scene->points(), scene->origin().seed);
}

}  // namespace snug::lesson
