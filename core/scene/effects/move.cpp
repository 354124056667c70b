// move: moves bodies by their velocities (physics/advance.hpp).
#include "physics/advance.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Move final : public Effect {
 public:
  void run(World& world) override {
    if (physics::advance(world)) world.state.changed(Slot::kPoses);
  }
  [[nodiscard]] bool idle(const World& world) const override { return physics::stands_still(world); }
};

}  // namespace

MadeEffect make_move(const EffectCall& call, World& world) { return Settings(call, world).make<Move>(); }

}  // namespace snug::scene
