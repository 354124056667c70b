// bounce: impulses with restitution and friction where bodies touch.
#include <algorithm>

#include "physics/budget.hpp"
#include "physics/limits.hpp"
#include "physics/manifold.hpp"
#include "physics/sleep.hpp"
#include "physics/start.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Bounce final : public Effect {
 public:
  Bounce(const physics::Surface& surface, bool sleeps) : surface_(surface), sleeps_(sleeps) {}

  void run(World& world) override {
    physics::Islands islands = physics::islands_of(world);
    physics::wake(world, islands);
    std::vector<physics::ContactRow> rows = physics::rows_of(world, surface_);
    physics::Budgets budgets(world, islands, surface_, rows);
    physics::solve(world, rows, surface_);
    for (const physics::Shift& shift : physics::shifts_apart(world, rows))
      if (budgets.push_apart(shift)) world.state.changed(Slot::kPoses);
    budgets.settle();
    if (sleeps_) physics::rest(world, islands, rows);
    world.state.changed(Slot::kVelocities);
  }

 private:
  physics::Surface surface_;
  bool sleeps_;
};

}  // namespace

MadeEffect make_bounce(const EffectCall& call, World& world) {
  Settings settings(call, world);
  physics::Surface surface;
  surface.restitution = settings.number("restitution", surface.restitution, 0, 1);
  surface.friction = settings.number("friction", surface.friction, 0, 100);
  constexpr std::string_view kSleeps[] = {"yes", "no"};
  const bool sleeps = settings.word("sleep", kSleeps) == 0;
  const auto name = [](const Member& member, const char* otherwise) {
    return member.name.empty() ? otherwise : member.name;
  };
  const auto shapeless = std::find_if(world.members.begin(), world.members.end(),
                                      [](const Member& member) { return !physics::has_manifolds(member.shape); });
  if (shapeless != world.members.end()) {
    settings.refuse("has impulses for spheres and boxes alone; give " + name(*shapeless, "each body") +
                    " such a shape");
    return settings.make<Bounce>(surface, sleeps);
  }
  const Member* const thinnest = physics::thinnest_of(world);
  const double rounds = physics::rounds_for(world, thinnest);
  if (!(rounds <= physics::limits::kMostRounds))
    settings.refuse("would need more than " + std::to_string(physics::limits::kMostRounds) +
                    " rounds a frame: " + name(*thinnest, "a body") + " is too thin for so long a step");
  else world.rounds = static_cast<int>(std::max(1.0, rounds));
  if (const Member* const fast = physics::too_fast(world))
    settings.refuse(name(*fast, "a body") + " is too fast: it would cross more than " +
                    std::to_string(static_cast<int>(physics::limits::kMostCrossed)) +
                    " times its own thickness in a frame");
  const auto [inside, wall] = physics::first_inside(world);
  if (inside != nullptr)
    settings.refuse(name(*inside, "a body") + " starts inside " + name(*wall, "a fixed one") +
                    ": move it out, or call it fixed too");
  world.solid = true;
  world.contacts = physics::contacts_at_start(world);
  return settings.make<Bounce>(surface, sleeps);
}

}  // namespace snug::scene
