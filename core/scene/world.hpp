// What effects read and write: the bodies, and what is derived from them, in slots that record when they
// changed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/aabb.hpp"
#include "geometry/body_pair.hpp"
#include "geometry/frustum.hpp"
#include "hierarchy/broad_phase/sweep_and_prune.hpp"
#include "physics/system.hpp"
#include "scene/declaration.hpp"

namespace snug::scene {

/// The slots through which effects exchange data. Time changes in every frame.
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

using physics::Contact;
using physics::Member;
using physics::Motion;
using physics::Shape;

/// How many pairs each stage left, how many the broad phase compared, and the axis along which it sorted (-1:
/// none), with how many swaps.
struct Funnel {
  std::int64_t all = 0, compared = 0, after_broad = 0, after_loose = 0, touching = 0;
  int axis = -1;
  std::int64_t swaps = 0;
};

/// The figures of the last update of the volumes.
struct Refitted {
  double slack = 0;  // that of all measured volumes together
  double cost = 0;   // points examined
  Volume3 first;     // the first body's volume, in the world frame
};

/// A projection: from a body's centre straight down to the ground.
struct Ray {
  V3 from = V3::Zero(), to = V3::Zero();
};

/// Everything that changes except the bodies themselves: what effects derived from them. A copy of it and of Moving is
/// a snapshot.
struct State {
  int frame = 0;
  std::array<std::uint64_t, kSlots> revisions{};
  std::vector<Aabb<double, 3>> volumes;
  Refitted refitted;
  std::vector<BodyPair> pairs;  // pairs whose AABBs overlap
  std::vector<BodyPair> near;   // those of them whose bounding spheres overlap
  Funnel funnel;
  hierarchy::SweepOrder sweep;
  std::vector<std::uint8_t> visibility;  // query::Culling, by body
  std::vector<std::vector<V3>> shadows;  // by body, a convex polygon on the ground
  std::vector<std::vector<V3>> trails;   // by body, the oldest place first
  std::vector<Ray> rays;                 // by body

  void changed(Slot slot) { ++revisions[static_cast<std::size_t>(slot)]; }
  [[nodiscard]] std::uint64_t revision(Slot slot) const { return revisions[static_cast<std::size_t>(slot)]; }
};

/// The bodies of a scene, and the data that its effects share.
struct World : physics::System {
  std::uint64_t seed = 1;
  V3 pulled_to = V3::Zero();                      // the point that drag pulls to
  std::optional<Frustum<double, 3>> camera = {};  // what culling tests against; none if nothing culls
  State state;

  /// A hash over every number of the bodies and of their contacts' memory.
  [[nodiscard]] std::uint64_t hash() const;
};

/// The box that a broad phase tests for a body: the AABB, with room for points that rounding may have put outside it,
/// and for a margin that the body may move until the next test.
[[nodiscard]] Aabb<double, 3> with_room(const Aabb<double, 3>& aabb, double margin);

/// declaration: one that check accepts.
[[nodiscard]] World world_of(const Declaration& declaration);

}  // namespace snug::scene
