// Bodies go where their velocities take them: the second half of semi-implicit Euler.
#pragma once

#include "physics/system.hpp"

namespace snug::physics {

/// Moves and turns the bodies that are awake by a round. Where the system is solid, a body that is too fast for
/// contacts to be found in time is stopped where it first touches another. Returns whether anything moved.
bool advance(System& system);

/// Whether every body that is awake has no velocity.
[[nodiscard]] bool stands_still(const System& system);

}  // namespace snug::physics
