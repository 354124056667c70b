// The impulses that keep bodies out of each other: one contact point after the other, again and again, each starting
// from its last impulse. Source: E. Catto, "Iterative dynamics with temporal coherence", 2005; "Continuous collision",
// 2013, for points not yet touching.
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
  BodyPair pair;
  V3 normal, first, second;  // the last two across the first
  V3 arm_a, arm_b;           // from the centres of mass
  double separation = 0, slop = 0;
  bool against_wall = false;  // one of the two does not move
  double normal_mass = 0, first_mass = 0,
         second_mass = 0;  // effective masses along each: impulse per unit of velocity
  double target = 0;       // the least velocity along the normal
  Impulse impulse;         // the sums so far
};

/// The points of all contacts in which a body is awake, warm-started with the last frame's impulses.
[[nodiscard]] std::vector<ContactRow> rows_of(const System& system, const Surface& surface);

/// Changes velocities, and keeps the impulses with which the next frame starts.
void solve(System& system, std::vector<ContactRow>& rows, const Surface& surface);

/// The rows without restitution: bodies that would separate stay in contact.
void remove_restitution(const System& system, std::vector<ContactRow>& rows);

/// How to move bodies apart that penetrate each other too deeply.
struct Shift {
  std::size_t body = 0;
  V3 by = V3::Zero();
  bool out_of_wall = false;  // the other one does not move
  bool driven = false;       // the other one is driven: what drives it has energy enough
};
[[nodiscard]] std::vector<Shift> shifts_apart(const System& system, const std::vector<ContactRow>& rows);

}  // namespace snug::physics
