// projection_rays: lines from each body straight down to the ground, which show where it is in space.
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class ProjectionRays final : public Effect {
 public:
  ProjectionRays(std::vector<std::size_t> bodies, double ground) : bodies_(std::move(bodies)), ground_(ground) {}

  void run(World& world) override {
    world.state.rays.resize(world.size());
    for (const std::size_t i : bodies_) {
      const V3& from = world.bodies[i].position;
      world.state.rays[i] = {from, V3(from[0], ground_, from[2])};
    }
    world.state.changed(Slot::kRays);
  }

 private:
  std::vector<std::size_t> bodies_;
  double ground_;
};

}  // namespace

MadeEffect make_projection_rays(const EffectCall& call, World& world) {
  Settings settings(call, world);
  auto bodies = settings.bodies();
  const double ground = settings.number("ground", 0, -1e9, 1e9);
  return settings.make<ProjectionRays>(std::move(bodies), ground);
}

}  // namespace snug::scene
