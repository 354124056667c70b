// Bodies push each other: impulses with restitution and friction where they touch. Bodies that lean on each other are
// an island; one of which every body has been still for a while sleeps, and wakes as a whole.
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/budget.hpp"
#include "scene/effect.hpp"
#include "scene/impulses.hpp"
#include "scene/islands.hpp"
#include "scene/limits.hpp"

namespace snug::scene {
namespace {

class Bounce final : public Effect {
 public:
  Bounce(const Surface& surface, bool sleeps) : surface_(surface), sleeps_(sleeps) {}

  void run(World& world) override {
    Islands islands = islands_of(world);
    wake(world, islands);
    std::vector<ContactRow> rows = rows_of(world, surface_);
    Budgets budgets(world, islands, surface_, rows);
    solve(world, rows, surface_);
    for (const Shift& shift : shifts_apart(world, rows)) budgets.push_apart(shift);
    budgets.settle();
    if (sleeps_) rest(world, islands, rows);
    world.state.changed(Slot::kVelocities);
  }

 private:
  static void wake(World& world, Islands& islands) {
    std::vector<bool> awake(world.size(), false);
    for (std::size_t i = 0; i < world.size(); ++i)
      if (world.awake(i)) awake[islands.of(i)] = true;
    // What is driven against a sleeper wakes it, where it moved since that fell asleep.
    for (const Contact& contact : world.state.contacts)
      for (const Index i : {contact.pair.a, contact.pair.b}) {
        const auto one = static_cast<std::size_t>(i),
                   other = static_cast<std::size_t>(contact.pair.a + contact.pair.b - i);
        if (world.members[one].driven && world.state.bodies[one].moved > world.state.bodies[other].moved)
          awake[islands.of(other)] = true;
      }
    for (std::size_t i = 0; i < world.size(); ++i)
      if (world.members[i].moves() && world.state.bodies[i].asleep && awake[islands.of(i)])
        world.state.bodies[i].wake();
  }

  /// Counts the rounds in which a body hardly moved. Those in which it moved little by little, to one side, do not
  /// count.
  static void watch(const World& world, std::size_t i, Motion& motion) {
    const double reach = world.members[i].shape.reach;
    motion.drifted += motion.velocity, motion.drifted_turning += motion.turning;
    const bool slow = std::max(motion.velocity.norm(), motion.turning.norm() * reach) < limits::kStill * world.pace();
    const bool drifts = std::max(motion.drifted.norm(), motion.drifted_turning.norm() * reach) >
                        limits::kDrifts * world.pace() * limits::kStillRounds;
    motion.still = slow && !drifts ? motion.still + 1 : 0;
    if (motion.still % limits::kStillRounds == 0) motion.drifted = motion.drifted_turning = V3::Zero();
  }

  static bool stands_still(const World& world, const Motion& motion) {
    return motion.position + motion.velocity * world.round() == motion.position && motion.turning == V3::Zero();
  }

  static void rest(World& world, Islands& islands, const std::vector<ContactRow>& rows) {
    std::vector<bool> held(world.size(), false), wakeful(world.size(), false);
    for (const ContactRow& row : rows)
      if (row.impulse.normal > 0) held[row.pair.a] = held[row.pair.b] = true;
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
    const bool fast =
        (motion.velocity.norm() + turning) * world.step > limits::kMostCrossed * 2 * member.shape.thinnest;
    if (member.moves() && fast) return &member;
  }
  return nullptr;
}

/// What separation_of returns; for bodies that are surely apart, a bound.
double separation_at_start(const World& world, std::size_t i, std::size_t j) {
  const double between = (world.state.bodies[j].position - world.state.bodies[i].position).norm();
  if (const double bound = between - world.members[i].shape.reach - world.members[j].shape.reach; bound > 0)
    return bound;
  return separation_of(world.members[i].shape, pose_of(world.state.bodies[i]), world.members[j].shape,
                       pose_of(world.state.bodies[j]));
}

/// The first that starts deep in what is fixed, and in what; nulls where none does. Nothing would pay for lifting it
/// out.
std::pair<const Member*, const Member*> first_inside(const World& world) {
  for (std::size_t j = 0; j < world.size(); ++j)
    for (std::size_t i = 0; world.members[j].fixed && i < world.size(); ++i) {
      const Member &body = world.members[i], &wall = world.members[j];
      if (body.moves() && separation_at_start(world, i, j) < -limits::kDeepestStart * body.shape.thinnest)
        return {&body, &wall};
    }
  return {nullptr, nullptr};
}

/// What touches at the start: narrow_phase first tells of it when the first round has let bodies fall into each other.
std::vector<Contact> contacts_at_start(const World& world) {
  std::vector<Contact> contacts;
  for (Index a = 0; a < static_cast<Index>(world.size()); ++a)
    for (Index b = a + 1; b < static_cast<Index>(world.size()); ++b) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      if (!world.members[i].moves() && !world.members[j].moves()) continue;
      const double separation = separation_at_start(world, i, j);
      if (separation <= world.slop({a, b})) contacts.push_back({{a, b}, separation <= 0});
    }
  return contacts;
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
  const auto name = [](const Member& member, const char* otherwise) {
    return member.name.empty() ? otherwise : member.name;
  };
  const auto shapeless = std::find_if(world.members.begin(), world.members.end(),
                                      [](const Member& member) { return !has_manifolds(member.shape); });
  if (shapeless != world.members.end()) {
    settings.refuse("has impulses for spheres and boxes alone; give " + name(*shapeless, "each body") +
                    " such a shape");
    return settings.make<Bounce>(surface, sleeps);
  }
  const Member* const thinnest = thinnest_of(world);
  const double rounds = rounds_for(world, thinnest);
  if (!(rounds <= limits::kMostRounds))
    settings.refuse("would need more than " + std::to_string(limits::kMostRounds) +
                    " rounds a frame: " + name(*thinnest, "a body") + " is too thin for so long a step");
  else world.rounds = static_cast<int>(std::max(1.0, rounds));
  if (const Member* const fast = too_fast(world))
    settings.refuse(name(*fast, "a body") + " is too fast: it would cross more than " +
                    std::to_string(static_cast<int>(limits::kMostCrossed)) + " times its own thickness in a frame");
  const auto [inside, wall] = first_inside(world);
  if (inside != nullptr)
    settings.refuse(name(*inside, "a body") + " starts inside " + name(*wall, "a fixed one") +
                    ": move it out, or call it fixed too");
  world.solid = true;
  world.state.contacts = contacts_at_start(world);
  return settings.make<Bounce>(surface, sleeps);
}

}  // namespace snug::scene
