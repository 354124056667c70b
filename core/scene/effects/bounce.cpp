// Bodies push each other: impulses with restitution and friction where they touch. Bodies that lean on each other are an
// island; one of which every body has been still for a while sleeps, and wakes as a whole.
#include <cmath>
#include <numeric>

#include "scene/effect.hpp"
#include "scene/impulses.hpp"
#include "scene/limits.hpp"

namespace snug::scene {
namespace {

class Islands {
 public:
  explicit Islands(std::size_t bodies) : parents_(bodies) { std::iota(parents_.begin(), parents_.end(), std::size_t{0}); }
  [[nodiscard]] std::size_t of(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parents_;
};

class Bounce final : public Effect {
 public:
  Bounce(const Surface& surface, bool sleeps) : surface_(surface), sleeps_(sleeps) {}

  void run(World& world) override {
    Islands islands = islands_of(world);
    wake(world, islands);
    std::vector<ContactRow> rows = rows_of(world, surface_);
    std::vector<Budget> budgets = budgets_of(world, islands, rows);
    solve(world, rows, surface_);
    for (const Shift& shift : shifts_apart(world, rows)) {
      const double work = -world.members[shift.body].mass * world.gravity.dot(shift.by);
      Budget& budget = budgets[islands.of(shift.body)];
      if (!budget.bounces && budget.pushed + work > budget.before) continue;
      budget.pushed += work;
      const Motion& motion = world.state.bodies[shift.body];
      world.place(shift.body, motion.position + shift.by, motion.orientation);
      world.state.changed(Slot::kPoses);
    }
    take_back(world, islands, budgets);
    if (sleeps_) rest(world, islands);
    world.state.changed(Slot::kVelocities);
  }

 private:
  static Islands islands_of(const World& world) {
    Islands islands(world.size());
    for (const Contact& contact : world.state.contacts) {
      const auto a = static_cast<std::size_t>(contact.pair.a), b = static_cast<std::size_t>(contact.pair.b);
      if (world.members[a].moves() && world.members[b].moves()) islands.join(a, b);
    }
    return islands;
  }

  static void wake(World& world, Islands& islands) {
    std::vector<bool> awake(world.size(), false);
    for (std::size_t i = 0; i < world.size(); ++i)
      if (world.awake(i)) awake[islands.of(i)] = true;
    // What is driven against a sleeper wakes it.
    for (const Contact& contact : world.state.contacts)
      for (const Index i : {contact.pair.a, contact.pair.b})
        if (world.members[static_cast<std::size_t>(i)].driven && world.state.bodies[static_cast<std::size_t>(i)].moved >= world.state.revision(Slot::kPoses))
          awake[islands.of(static_cast<std::size_t>(contact.pair.a + contact.pair.b - i))] = true;
    for (std::size_t i = 0; i < world.size(); ++i)
      if (world.members[i].moves() && world.state.bodies[i].asleep && awake[islands.of(i)]) world.state.bodies[i].asleep = false, world.state.bodies[i].still = 0;
  }

  /// What an island may spend in a frame: the kinetic energy with which it came in, before gravity added to it.
  struct Budget {
    double before = 0;
    double kinetic = 0, falls = 0;  // as it goes out, and what its motion then takes from the field of gravity
    double pushed = 0;              // what pushing bodies apart gave to that
    bool bounces = false;           // restitution gives back what an earlier frame took
  };

  static std::vector<Budget> budgets_of(const World& world, Islands& islands, const std::vector<ContactRow>& rows) {
    std::vector<Budget> budgets(world.size());
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Motion motion = world.state.bodies[i];
      motion.velocity -= world.gravity * world.step;
      budgets[islands.of(i)].before += kinetic_energy(world.members[i], motion);
    }
    for (const ContactRow& row : rows)
      for (const Index i : {row.pair.a, row.pair.b})
        if (row.target > 0) budgets[islands.of(static_cast<std::size_t>(i))].bounces = true;
    return budgets;
  }

  /// Exact impulses without restitution take energy away. These are not quite exact, so that an island may go out with a
  /// trace more than it came in with: then it is made slower as a whole, by just so much, by which nothing moves into
  /// anything. With its velocities times s, s^2 kinetic - s falls + pushed = before.
  static void take_back(World& world, Islands& islands, std::vector<Budget>& budgets) {
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Budget& budget = budgets[islands.of(i)];
      budget.kinetic += kinetic_energy(world.members[i], world.state.bodies[i]);
      budget.falls += world.members[i].mass * world.step * world.gravity.dot(world.state.bodies[i].velocity);
    }
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Budget& budget = budgets[islands.of(i)];
      const double left = budget.before - budget.pushed;
      if (!world.awake(i) || budget.bounces || budget.kinetic - budget.falls <= left) continue;
      const double root = std::sqrt(std::max(0.0, budget.falls * budget.falls + 4 * budget.kinetic * left));
      const double part = budget.kinetic > 0 ? std::clamp((budget.falls + root) / (2 * budget.kinetic), 0.0, 1.0) : 1;
      world.state.bodies[i].velocity *= part, world.state.bodies[i].turning *= part;
    }
  }

  static void rest(World& world, Islands& islands) {
    std::vector<int> still(world.size(), limits::kStillFrames);
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Motion& motion = world.state.bodies[i];
      const bool slow = motion.velocity.norm() < limits::kStillSpeed && motion.turning.norm() < limits::kStillTurning;
      motion.still = slow ? motion.still + 1 : 0;
      still[islands.of(i)] = std::min(still[islands.of(i)], motion.still);
    }
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i) || still[islands.of(i)] < limits::kStillFrames) continue;
      Motion& motion = world.state.bodies[i];
      motion.asleep = true;
      motion.velocity = motion.turning = V3::Zero();
    }
  }

  Surface surface_;
  bool sleeps_;
};

}  // namespace

MadeEffect make_bounce(const EffectCall& call, World& world) {
  Settings settings(call, world);
  Surface surface;
  surface.restitution = settings.number("restitution", surface.restitution, 0, 1);
  surface.friction = settings.number("friction", surface.friction, 0, 100);
  constexpr std::string_view kSleeps[] = {"yes", "no"};
  const bool sleeps = settings.word("sleep", kSleeps) == 0;
  for (const Member& member : world.members)
    if (!has_manifolds(member.shape)) settings.refuse("has impulses for spheres and boxes alone; give " + (member.name.empty() ? "each body" : member.name) + " such a shape");
  world.solid = true;
  return settings.make<Bounce>(surface, sleeps);
}

}  // namespace snug::scene
