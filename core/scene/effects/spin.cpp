// spin: rotates a body about an axis through its centre, at constant speed.
#include <numbers>

#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Spin final : public Effect {
 public:
  Spin(std::vector<std::size_t> bodies, World& world, const V3& axis, double turns, double degrees)
      : bodies_(std::move(bodies)), axis_(axis), turns_(turns), most_(degrees > 0 ? degrees / 360 : 0) {
    for (const std::size_t i : bodies_) {
      world.members[i].driven = true;
      starts_.push_back(world.bodies[i].orientation);
    }
  }

  void run(World& world) override {
    const Quaternion turn = quaternion_about(axis_, 2 * std::numbers::pi * turned_at(world, world.state.frame));
    for (std::size_t k = 0; k < bodies_.size(); ++k)
      world.place(bodies_[k], world.bodies[bodies_[k]].position, normalized(turn * starts_[k]));
    world.state.changed(Slot::kPoses);
  }
  [[nodiscard]] bool idle(const World& world) const override {
    return turned_at(world, world.state.frame) == turned_at(world, world.state.frame - 1);
  }

 private:
  /// The angle at a frame, in turns.
  [[nodiscard]] double turned_at(const World& world, int frame) const {
    const double turned = turns_ * world.step * frame;
    return most_ > 0 && std::abs(turned) > most_ ? std::copysign(most_, turned) : turned;
  }

  std::vector<std::size_t> bodies_;
  V3 axis_;
  double turns_, most_;
  std::vector<Quaternion> starts_;
};

}  // namespace

MadeEffect make_spin(const EffectCall& call, World& world) {
  Settings settings(call, world);
  auto bodies = settings.bodies();
  const V3 axis = settings.vector("axis", V3::UnitY());
  const double turns = settings.number("turns_per_second", 0.1, -100, 100);
  const double degrees = settings.number("degrees", 0, 0, 1e6);  // the angle at which it stops; 0: never
  if (axis == V3::Zero()) settings.refuse("its axis has no direction");
  return settings.make<Spin>(std::move(bodies), world, axis, turns, degrees);
}

}  // namespace snug::scene
