// An island sleeps once all of its bodies have been still for a while, and wakes as a whole.
#pragma once

#include <vector>

#include "physics/impulses.hpp"
#include "physics/islands.hpp"

namespace snug::physics {

/// Wakes each island in which a body is awake, or against which a driven body has moved since it fell asleep.
void wake(System& system, Islands& islands);

/// Puts to sleep each island whose bodies have all been still for long enough, held by a contact or at rest in free
/// space. rows: solved.
void rest(System& system, Islands& islands, const std::vector<ContactRow>& rows);

}  // namespace snug::physics
