// narrow_phase: finds the remaining pairs that touch: by spheres around each body in every orientation, then exactly.
#include "geometry/tolerance.hpp"
#include "scene/effect.hpp"
#include "scene/shape.hpp"

namespace snug::scene {
namespace {

class NarrowPhase final : public Effect {
 public:
  void run(World& world) override {
    State& state = world.state;
    world.contacts.clear();
    state.near.clear();
    state.funnel.touching = 0;
    for (const BodyPair& pair : state.pairs) {
      const std::size_t a = pair.a, b = pair.b;
      if (!near(world, a, b)) continue;
      state.near.push_back(pair);
      const bool touching =
          touch(world.members[a].shape, pose_of(world.bodies[a]), world.members[b].shape, pose_of(world.bodies[b]));
      state.funnel.touching += touching ? 1 : 0;
      if (touching || (world.solid && (world.members[a].moves() || world.members[b].moves())))
        world.contacts.push_back({pair, touching});
    }
    state.funnel.after_loose = static_cast<std::int64_t>(state.near.size());
    state.changed(Slot::kContacts);
  }

 private:
  static bool near(const World& world, std::size_t a, std::size_t b) {
    const double reach =
        world.members[a].shape.reach + world.members[b].shape.reach + world.margin(a) + world.margin(b);
    const V3 between = world.bodies[b].position - world.bodies[a].position;
    return between.squaredNorm() <= reach * reach * (1 + tolerance::kSquaredDistance<double>);
  }
};

}  // namespace

MadeEffect make_narrow_phase(const EffectCall& call, World& world) { return Settings(call, world).make<NarrowPhase>(); }

}  // namespace snug::scene
