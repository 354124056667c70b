// What effects read and write: the bodies as they stand, and what was made of them, in slots that know when they
// changed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/declaration.hpp"
#include "scene/shape.hpp"

namespace snug::scene {

/// What effects hand to each other. time changes with every frame.
enum class Slot : std::uint8_t {
  kTime,
  kPoses,
  kVelocities,
  kVolumes,
  kPairs,
  kContacts,
  kVisibility,
  kShadows,
  kTrails,
  kRays
};
inline constexpr std::size_t kSlots = 10;
inline constexpr std::array<std::string_view, kSlots> kSlotNames{
    "time", "poses", "velocities", "volumes", "pairs", "contacts", "visibility", "shadows", "trails", "rays"};

/// A set of slots, a bit for each.
using SlotSet = std::uint32_t;
[[nodiscard]] constexpr SlotSet bit(Slot slot) { return SlotSet{1} << static_cast<int>(slot); }
template <class... Slots>
[[nodiscard]] constexpr SlotSet slots(Slots... all) {
  return (SlotSet{0} | ... | bit(all));
}
[[nodiscard]] constexpr bool has(SlotSet set, Slot slot) { return (set & bit(slot)) != 0; }

/// What of a body stays as it is.
struct Member {
  std::string name;
  Shape shape;  // about its centre of mass
  bool fixed = false;
  bool driven = false;              // an effect says where it is: neither velocities nor impulses move it
  double mass = 0;                  // 0: nothing pushes it
  V3 inverse_inertia = V3::Zero();  // about its own axes
  [[nodiscard]] bool moves() const { return mass > 0 && !driven; }
};

/// A body as it stands.
struct Motion {
  V3 position = V3::Zero();
  Quaternion orientation;
  Matrix<double, 3> rotation = Matrix<double, 3>::Identity();  // of the orientation
  V3 velocity = V3::Zero();
  V3 turning = V3::Zero();
  int still = 0;                                          // for how many rounds it hardly moved
  V3 drifted = V3::Zero(), drifted_turning = V3::Zero();  // the sums of its velocities in the last of these
  bool asleep = false;
  std::uint64_t moved = 0;  // the revision of poses with which it moved last, or fell asleep

  void wake() { asleep = false, still = 0, drifted = drifted_turning = V3::Zero(); }
};

[[nodiscard]] inline Pose<double, 3> pose_of(const Motion& motion) { return {motion.rotation, motion.position}; }

/// Two bodies, a < b.
struct Pair {
  Index a = 0, b = 0;
  friend bool operator==(const Pair&, const Pair&) = default;
  friend bool operator<(const Pair& x, const Pair& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; }
};

/// Two bodies that touch, or could before the next frame.
struct Contact {
  Pair pair;
  bool touching = false;
};

/// What a contact's point held in the last frame, by which the next one begins.
struct Impulse {
  Pair pair;
  V3 on_a = V3::Zero(), on_b = V3::Zero();   // where, in each body's own frame
  double normal = 0, first = 0, second = 0;  // kg scene units / s
  double approach = 0;                       // at which speed the bodies came, where they have yet to bounce
  double owed = 0;                           // the energy that slowing down for that took
};

/// How many pairs each stage left, how many the first one had to compare for it, and along which axis it sorted (-1:
/// none).
struct Funnel {
  std::int64_t all = 0, compared = 0, after_broad = 0, after_loose = 0, touching = 0;
  int axis = -1;
};

/// What the volumes came to when they were last updated.
struct Refitted {
  double slack = 0;  // of all measured together, over the tightest
  double cost = 0;   // points looked at
  Volume3 first;     // the first body's volume, in the world
};

/// A projection: from a body's centre to its foot on the ground.
struct Ray {
  V3 from = V3::Zero(), to = V3::Zero();
};

/// All that changes. A copy of it is a snapshot.
struct State {
  int frame = 0;
  std::array<std::uint64_t, kSlots> revisions{};
  std::vector<Motion> bodies;
  std::vector<Aabb<double, 3>> volumes;
  Refitted refitted;
  std::vector<Pair> pairs;  // whose boxes overlap
  std::vector<Pair> near;   // of those, whose loose spheres do
  std::vector<Contact> contacts;
  std::vector<Impulse> impulses;
  Funnel funnel;
  std::vector<std::uint8_t> visibility;  // query::Culling, by body
  std::vector<std::vector<V3>> shadows;  // by body, a convex polygon on the ground
  std::vector<std::vector<V3>> trails;   // by body, the oldest place first
  std::vector<Ray> rays;                 // by body

  void changed(Slot slot) { ++revisions[static_cast<std::size_t>(slot)]; }
  [[nodiscard]] std::uint64_t revision(Slot slot) const { return revisions[static_cast<std::size_t>(slot)]; }
};

/// What stays, and what changes.
struct World {
  std::vector<Member> members;
  double step = 0;  // seconds a frame
  int rounds = 1;   // in how many equal parts of it what moves by velocities goes: set by bounce
  std::uint64_t seed = 1;
  V3 gravity = V3::Zero();    // scene units / s^2: set by fall
  bool solid = false;         // bodies do not pass through each other: set by bounce
  V3 pulled_to = V3::Zero();  // where drag pulls
  State state;

  [[nodiscard]] std::size_t size() const { return members.size(); }
  /// Whether velocities change where the body is, and it is not asleep.
  [[nodiscard]] bool awake(std::size_t i) const { return members[i].moves() && !state.bodies[i].asleep; }
  [[nodiscard]] bool any_awake() const;
  /// Turns and moves a body. The caller says that poses changed.
  void place(std::size_t i, const V3& position, const Quaternion& orientation);
  [[nodiscard]] double round() const { return step / rounds; }  // seconds
  /// What gravity adds to a speed in a round, or would where there is none: speeds are held against it.
  [[nodiscard]] double pace() const;
  /// The half thickness of the thinner one, or where one alone moves, of that, scene units: a floor may be as thin as
  /// paper.
  [[nodiscard]] double thinner(const Pair& pair) const;
  /// How deep the two may lie in each other, scene units.
  [[nodiscard]] double slop(const Pair& pair) const;
  /// How far ahead of a body contacts are looked for, scene units.
  [[nodiscard]] double margin(std::size_t i) const;
  /// The energy of all bodies that velocities move, with what gravity may still give them.
  [[nodiscard]] double energy() const;
  /// A hash over every number of the bodies and of what their contacts remember.
  [[nodiscard]] std::uint64_t hash() const;
};

/// declaration: one that check accepts.
[[nodiscard]] World world_of(const Declaration& declaration);

/// (I^-1 in the world) v.
[[nodiscard]] V3 by_inverse_inertia(const Member& member, const Motion& motion, const V3& v);
[[nodiscard]] double kinetic_energy(const Member& member, const Motion& motion);

}  // namespace snug::scene
