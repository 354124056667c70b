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
    for (const Shift& shift : shifts_apart(world, rows)) push_apart(world, budgets[islands.of(shift.body)], shift);
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

  /// Out of a wall all of the way, where what an impact takes away pays for it; else a part of it, or none.
  static void push_apart(World& world, Budget& budget, const Shift& shift) {
    const Motion& motion = world.state.bodies[shift.body];
    const double work = -world.members[shift.body].mass * world.gravity.dot(shift.by);
    const auto affords = [&](double part) { return budget.bounces || budget.pushed + part * work <= budget.before; };
    const double part = shift.out_of_wall && !budget.bounces && affords(1) ? 1 : limits::kMended;
    if (!affords(part)) return;
    budget.pushed += part * work;
    world.place(shift.body, motion.position + part * shift.by, motion.orientation);
    world.state.changed(Slot::kPoses);
  }

  static std::vector<Budget> budgets_of(const World& world, Islands& islands, const std::vector<ContactRow>& rows) {
    std::vector<Budget> budgets(world.size());
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Motion motion = world.state.bodies[i];
      motion.velocity -= world.gravity * world.round();
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
      budget.falls += world.members[i].mass * world.round() * world.gravity.dot(world.state.bodies[i].velocity);
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
    const double slow = limits::kStill * world.pace();
    std::vector<int> still(world.size(), limits::kStillRounds);
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Motion& motion = world.state.bodies[i];
      const double fastest = std::max(motion.velocity.norm(), motion.turning.norm() * world.members[i].shape.reach);
      motion.still = fastest < slow ? motion.still + 1 : 0;
      still[islands.of(i)] = std::min(still[islands.of(i)], motion.still);
    }
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i) || still[islands.of(i)] < limits::kStillRounds) continue;
      Motion& motion = world.state.bodies[i];
      motion.asleep = true;
      motion.velocity = motion.turning = V3::Zero();
    }
  }

  Surface surface_;
  bool sleeps_;
};

/// The thinnest that velocities move; null where nothing does.
const Member* thinnest_of(const World& world) {
  const Member* thinnest = nullptr;
  for (const Member& member : world.members)
    if (member.moves() && (thinnest == nullptr || member.shape.thinnest < thinnest->shape.thinnest)) thinnest = &member;
  return thinnest;
}

/// Into how many rounds a frame is cut.
double rounds_for(const World& world, const Member* thinnest) {
  double longest = limits::kLongestRound;
  if (thinnest != nullptr && world.gravity != V3::Zero())
    longest = std::min(longest, std::sqrt(limits::kFallInRound * thinnest->shape.thinnest / world.gravity.norm()));
  return std::ceil(world.step / longest);
}

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
  const Member* const thinnest = thinnest_of(world);
  const double rounds = rounds_for(world, thinnest);
  if (!(rounds <= limits::kMostRounds))
    settings.refuse("would need more than " + std::to_string(limits::kMostRounds) + " rounds a frame: " +
                    (thinnest->name.empty() ? "a body" : thinnest->name) + " is too thin for so long a step");
  else world.rounds = static_cast<int>(std::max(1.0, rounds));
  world.solid = true;
  return settings.make<Bounce>(surface, sleeps);
}

}  // namespace snug::scene
