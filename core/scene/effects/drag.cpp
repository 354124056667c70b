// drag: pulls a body to a point by a critically damped spring, so that it arrives without oscillating.
#include <cmath>

#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Drag final : public Effect {
 public:
  Drag(std::size_t body, double stiffness) : body_(body), stiffness_(stiffness) {}

  void run(World& world) override {
    if (!world.awake(body_)) return;
    Motion& motion = world.bodies[body_];
    // Implicit in the velocity, so that no stiffness makes it unstable.
    const double seconds = world.round(), pull = stiffness_ * seconds, damping = 2 * std::sqrt(stiffness_) * seconds;
    motion.velocity = (motion.velocity + pull * (world.pulled_to - motion.position)) / (1 + damping + pull * seconds);
    world.state.changed(Slot::kVelocities);
  }
  [[nodiscard]] bool idle(const World& world) const override { return !world.awake(body_); }

 private:
  std::size_t body_;
  double stiffness_;
};

}  // namespace

MadeEffect make_drag(const EffectCall& call, World& world) {
  Settings settings(call, world);
  const std::size_t body = settings.body();
  world.pulled_to = settings.vector("to", V3::Zero());
  const double stiffness = settings.number("stiffness", 40, 0, 1e4);  // 1 / s^2
  return settings.make<Drag>(body, stiffness);
}

}  // namespace snug::scene
