#include "lesson/subjects/scene/pictured.hpp"

#include "query/cull/classify.hpp"

namespace snug::lesson {

Pictured pictured_in(const scene::Scene& scene) {
  const scene::State& state = scene.world().state;
  Pictured pictured{.effects = static_cast<int>(scene.tallies().size())};
  for (const auto& shadow : state.shadows) pictured.shadows += shadow.empty() ? 0 : 1;
  for (const auto& trail : state.trails) pictured.trails += trail.size() < 2 ? 0 : 1;
  for (const scene::Ray& ray : state.rays) pictured.rays += ray.from == ray.to ? 0 : 1;
  for (const std::uint8_t seen : state.visibility)
    pictured.culled += seen == static_cast<std::uint8_t>(query::Culling::kOutside) ? 1 : 0;
  return pictured;
}

}  // namespace snug::lesson
