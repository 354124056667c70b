// What has to be known about rigid bodies before their first round: into how many rounds a frame is divided, and what
// cannot be simulated.
#pragma once

#include <utility>
#include <vector>

#include "physics/system.hpp"

namespace snug::physics {

/// The thinnest body that velocities move; null where there is none.
[[nodiscard]] const Member* thinnest_of(const System& system);

/// How many rounds a frame takes, a whole number however large. thinnest: thinnest_of(system).
[[nodiscard]] double rounds_for(const System& system, const Member* thinnest);

/// The first body that crosses too many of its own thicknesses in a frame; null where none does.
[[nodiscard]] const Member* too_fast(const System& system);

/// The first body that starts deep in a fixed one, and that one; nulls where none does. Nothing would pay for lifting
/// it out.
[[nodiscard]] std::pair<const Member*, const Member*> first_inside(const System& system);

/// The contacts at the start: looked for only after the first round, they would be found when bodies have already
/// fallen into each other.
[[nodiscard]] std::vector<Contact> contacts_at_start(const System& system);

}  // namespace snug::physics
