// Bodies go where their velocities take them: the second half of semi-implicit Euler.
#pragma once

#include "physics/system.hpp"

namespace snug::physics {

/// Moves and turns what is awake by a round. Where the system is solid, a body that is too fast for contacts to be seen
/// coming is stopped where it first touches another. Whether anything moved.
bool advance(System& system);

/// Whether no body that is awake has a velocity.
[[nodiscard]] bool stands_still(const System& system);

}  // namespace snug::physics
