// Bodies push each other: impulses with restitution and friction where they touch. Bodies that lean on each other are an
// island; one of which every body has been still for a while sleeps, and wakes as a whole.
#include <algorithm>
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
    // Copies are taken only where a bounce may have to be solved once more.
    const bool bounces = std::any_of(budgets.begin(), budgets.end(), [](const Budget& budget) { return budget.bounces; });
    const std::vector<Motion> before = bounces ? world.state.bodies : std::vector<Motion>();
    const std::vector<ContactRow> unsolved = bounces ? rows : std::vector<ContactRow>();
    solve(world, rows, surface_);
    for (const Shift& shift : shifts_apart(world, rows)) push_apart(world, budgets[islands.of(shift.body)], shift);
    sum_up(world, islands, budgets);
    if (std::any_of(budgets.begin(), budgets.end(), [](const Budget& budget) { return budget.bounces && budget.is_exceeded(); }))
      bounce_less(world, islands, budgets, before, unsolved);
    take_back(world, islands, budgets);
    remember(world, islands, budgets);
    if (sleeps_) rest(world, islands, rows);
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
    // What is driven against a sleeper wakes it, where it moved since that fell asleep.
    for (const Contact& contact : world.state.contacts)
      for (const Index i : {contact.pair.a, contact.pair.b}) {
        const auto one = static_cast<std::size_t>(i), other = static_cast<std::size_t>(contact.pair.a + contact.pair.b - i);
        if (world.members[one].driven && world.state.bodies[one].moved > world.state.bodies[other].moved) awake[islands.of(other)] = true;
      }
    for (std::size_t i = 0; i < world.size(); ++i)
      if (world.members[i].moves() && world.state.bodies[i].asleep && awake[islands.of(i)]) world.state.bodies[i].wake();
  }

  /// What an island may spend in a round: the kinetic energy with which it came in, before gravity added to it; and where it
  /// bounces, what slowing down for that took from it before.
  struct Budget {
    double before = 0, owed = 0;
    double kinetic = 0, falls = 0;  // as it goes out, and what its motion then takes from the field of gravity
    double pushed = 0;              // what pushing bodies apart gave to that
    bool bounces = false;
    [[nodiscard]] double may_spend() const { return before + (bounces ? owed : 0); }
    [[nodiscard]] double left() const { return may_spend() - pushed; }
    [[nodiscard]] bool is_exceeded() const { return kinetic - falls > left(); }
  };

  /// Out of a wall all of the way, where what an impact takes away pays for it; else a part of it, or none.
  static void push_apart(World& world, Budget& budget, const Shift& shift) {
    const Motion& motion = world.state.bodies[shift.body];
    const double work = shift.driven ? 0 : -world.members[shift.body].mass * world.gravity.dot(shift.by);
    const auto affords = [&](double part) { return shift.driven || budget.pushed + part * work <= budget.may_spend(); };
    const double part = shift.driven || (shift.out_of_wall && !budget.bounces && affords(1)) ? 1 : limits::kMended;
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
    for (const Impulse& held : world.state.impulses) budgets[island_of(world, islands, held.pair)].owed += held.owed;
    for (const ContactRow& row : rows)
      if (row.target > 0) budgets[island_of(world, islands, row.pair)].bounces = true;
    return budgets;
  }

  /// Of a pair of which one moves at least.
  static std::size_t island_of(const World& world, Islands& islands, const Pair& pair) {
    const auto a = static_cast<std::size_t>(pair.a);
    return islands.of(world.members[a].moves() ? a : static_cast<std::size_t>(pair.b));
  }

  static void sum_up(const World& world, Islands& islands, std::vector<Budget>& budgets) {
    for (Budget& budget : budgets) budget.kinetic = budget.falls = 0;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Budget& budget = budgets[islands.of(i)];
      budget.kinetic += kinetic_energy(world.members[i], world.state.bodies[i]);
      budget.falls += world.members[i].mass * world.round() * world.gravity.dot(world.state.bodies[i].velocity);
    }
  }

  /// What each point of a contact gives back of its own speed can come to more than all brought. With velocities v1, which
  /// bounce, and v0, which do not and never gain, an island goes out with v0 + s (v1 - v0): the greatest s for which it
  /// spends no more than it may. What keeps bodies apart is linear, so that it holds between the two.
  void bounce_less(World& world, Islands& islands, std::vector<Budget>& budgets, const std::vector<Motion>& before, std::vector<ContactRow> rows) const {
    const std::vector<Budget> with = budgets;
    std::vector<Motion> bouncing = world.state.bodies;
    const std::vector<Impulse> impulses = world.state.impulses;
    for (std::size_t i = 0; i < world.size(); ++i) world.state.bodies[i].velocity = before[i].velocity, world.state.bodies[i].turning = before[i].turning;
    stop_bouncing(world, rows);
    solve(world, rows, surface_);
    sum_up(world, islands, budgets);
    std::vector<double> gained(world.size());  // the energy of v1 - v0
    for (std::size_t i = 0; i < world.size(); ++i) {
      bouncing[i].velocity -= world.state.bodies[i].velocity, bouncing[i].turning -= world.state.bodies[i].turning;
      if (world.awake(i)) gained[islands.of(i)] += kinetic_energy(world.members[i], bouncing[i]);
    }
    std::vector<double> parts(world.size());
    for (std::size_t i = 0; i < world.size(); ++i) parts[i] = with[i].is_exceeded() ? most_bounce(budgets[i], with[i], gained[i]) : 1;
    for (std::size_t i = 0; i < world.size(); ++i) {
      const double part = parts[islands.of(i)];
      world.state.bodies[i].velocity += part * bouncing[i].velocity, world.state.bodies[i].turning += part * bouncing[i].turning;
    }
    for (std::size_t k = 0; k < impulses.size(); ++k) {
      Impulse& impulse = world.state.impulses[k];
      const double part = parts[island_of(world, islands, impulse.pair)];
      impulse.normal += part * (impulses[k].normal - impulse.normal);
      impulse.first += part * (impulses[k].first - impulse.first);
      impulse.second += part * (impulses[k].second - impulse.second);
    }
    sum_up(world, islands, budgets);
  }

  /// The greater root of gained s^2 + linear s = what v0 left.
  static double most_bounce(const Budget& without, const Budget& with, double gained) {
    const double left = without.left() - (without.kinetic - without.falls);
    const double linear = (with.kinetic - with.falls) - (without.kinetic - without.falls) - gained;
    if (left <= 0 || gained <= 0) return 0;
    return std::clamp((std::sqrt(linear * linear + 4 * gained * left) - linear) / (2 * gained), 0.0, 1.0);
  }

  /// Exact impulses without restitution take energy away. These are not quite exact, so that an island may go out with a
  /// trace more than it came in with: then it is made slower as a whole, by just so much, by which nothing moves into
  /// anything. With its velocities times s, s^2 kinetic - s falls = what is left.
  static void take_back(World& world, Islands& islands, const std::vector<Budget>& budgets) {
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Budget& budget = budgets[islands.of(i)];
      if (!world.awake(i) || !budget.is_exceeded()) continue;
      const double root = std::sqrt(std::max(0.0, budget.falls * budget.falls + 4 * budget.kinetic * budget.left()));
      const double part = budget.kinetic > 0 ? std::clamp((budget.falls + root) / (2 * budget.kinetic), 0.0, 1.0) : 1;
      world.state.bodies[i].velocity *= part, world.state.bodies[i].turning *= part;
    }
  }

  /// What an island lost is owed to the first of its contacts that have yet to bounce.
  static void remember(World& world, Islands& islands, std::vector<Budget>& budgets) {
    for (Impulse& impulse : world.state.impulses) {
      if (impulse.approach <= 0) continue;
      Budget& budget = budgets[island_of(world, islands, impulse.pair)];
      impulse.owed = std::max(0.0, budget.before + budget.owed - budget.pushed - (budget.kinetic - budget.falls));
      budget = {};
    }
  }

  /// Counts the rounds in which a body hardly moved. Those in which it moved little by little, to one side, do not count.
  static void watch(const World& world, std::size_t i, Motion& motion) {
    const double reach = world.members[i].shape.reach;
    motion.drifted += motion.velocity, motion.drifted_turning += motion.turning;
    const bool slow = std::max(motion.velocity.norm(), motion.turning.norm() * reach) < limits::kStill * world.pace();
    const bool drifts = std::max(motion.drifted.norm(), motion.drifted_turning.norm() * reach) > limits::kDrifts * world.pace() * limits::kStillRounds;
    motion.still = slow && !drifts ? motion.still + 1 : 0;
    if (motion.still % limits::kStillRounds == 0) motion.drifted = motion.drifted_turning = V3::Zero();
  }

  static bool stands_still(const World& world, const Motion& motion) {
    return motion.position + motion.velocity * world.round() == motion.position && motion.turning == V3::Zero();
  }

  static void rest(World& world, Islands& islands, const std::vector<ContactRow>& rows) {
    std::vector<bool> held(world.size(), false), wakeful(world.size(), false);
    for (const ContactRow& row : rows)
      if (row.impulse.normal > 0) held[static_cast<std::size_t>(row.pair.a)] = held[static_cast<std::size_t>(row.pair.b)] = true;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i)) continue;
      Motion& motion = world.state.bodies[i];
      watch(world, i, motion);
      const bool rests = motion.still >= limits::kStillRounds && (held[i] || stands_still(world, motion));
      if (!rests) wakeful[islands.of(i)] = true;
    }
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!world.awake(i) || wakeful[islands.of(i)]) continue;
      Motion& motion = world.state.bodies[i];
      motion.asleep = true;
      motion.moved = world.state.revision(Slot::kPoses);
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

/// The first that crosses too many of its own thicknesses in a frame; null where none does.
const Member* too_fast(const World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Member& member = world.members[i];
    const Motion& motion = world.state.bodies[i];
    const double turning = member.shape.kind == Shape::Kind::kSphere ? 0 : motion.turning.norm() * member.shape.reach;
    const bool fast = (motion.velocity.norm() + turning) * world.step > limits::kMostCrossed * 2 * member.shape.thinnest;
    if (member.moves() && fast) return &member;
  }
  return nullptr;
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
  if (const Member* const fast = too_fast(world))
    settings.refuse((fast->name.empty() ? "a body" : fast->name) + " is too fast: it would cross more than " +
                    std::to_string(static_cast<int>(limits::kMostCrossed)) + " times its own thickness in a frame");
  world.solid = true;
  return settings.make<Bounce>(surface, sleeps);
}

}  // namespace snug::scene
