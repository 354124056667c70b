// The impulses that keep bodies out of each other: one point after the other, over and over, each from what it held
// last. Source: E. Catto, "Iterative dynamics with temporal coherence", 2005; "Continuous collision", 2013, for points
// not yet touching.
#pragma once

#include <vector>

#include "physics/manifold.hpp"
#include "physics/system.hpp"

namespace snug::physics {

struct Surface {
  double restitution = 0.3;  // 0 … 1
  double friction = 0.5;     // >= 0
};

/// A point of a contact while impulses are found.
struct ContactRow {
  Pair pair;
  V3 normal, first, second;  // the last two across the first
  V3 arm_a, arm_b;           // from the centres of mass
  double separation = 0, slop = 0;
  bool against_wall = false;  // one of the two does not move
  double mass = 0, mass_first = 0,
         mass_second = 0;  // along each: what one unit of impulse changes a unit of velocity of
  double target = 0;       // the velocity along the normal must not be below it
  Impulse impulse;         // the sums so far
};

/// The points of all contacts in which a body is awake, warm from the last frame's impulses.
[[nodiscard]] std::vector<ContactRow> rows_of(const System& system, const Surface& surface);

/// Changes velocities, and keeps what the next frame begins from.
void solve(System& system, std::vector<ContactRow>& rows, const Surface& surface);

/// The rows as they are without restitution: what would go apart only stays.
void stop_bouncing(const System& system, std::vector<ContactRow>& rows);

/// How bodies that lie deeper in each other than they may are to be moved apart.
struct Shift {
  std::size_t body = 0;
  V3 by = V3::Zero();
  bool out_of_wall = false;  // the other one does not move
  bool driven = false;       // the other one is driven: what drives it has energy enough
};
[[nodiscard]] std::vector<Shift> shifts_apart(const System& system, const std::vector<ContactRow>& rows);

}  // namespace snug::physics
