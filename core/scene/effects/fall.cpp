// fall: gravity. Velocities change first and positions after them (move.cpp), which is semi-implicit Euler. In each
// step, a body in free fall loses m (g step)^2 / 2 of its energy, and never gains any.
#include <algorithm>

#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Fall final : public Effect {
 public:
  void run(World& world) override {
    for (std::size_t i = 0; i < world.size(); ++i)
      if (world.awake(i)) world.bodies[i].velocity += world.gravity * world.round();
    world.state.changed(Slot::kVelocities);
  }
  [[nodiscard]] bool idle(const World& world) const override {
    return world.gravity == V3::Zero() || !world.any_awake();
  }
};

}  // namespace

MadeEffect make_fall(const EffectCall& call, World& world) {
  Settings settings(call, world);
  world.gravity = settings.vector("gravity", V3(0, -9.81, 0));
  const auto is = [&](auto has) { return std::any_of(world.members.begin(), world.members.end(), has); };
  if (!is([](const Member& member) { return member.moves(); }) &&
      is([](const Member& member) { return member.driven; }))
    settings.refuse("nothing falls: other effects drive every body that is not fixed");
  return settings.make<Fall>();
}

}  // namespace snug::scene
