#include "physics/sleep.hpp"

#include <algorithm>

#include "physics/limits.hpp"

namespace snug::physics {
namespace {

/// Counts the rounds in a row in which a body hardly moved. Rounds in which it creeps in one direction do not count.
void watch(const System& system, std::size_t i, Motion& motion) {
  const double reach = system.members[i].shape.reach;
  motion.drifted += motion.velocity;
  motion.drifted_angular += motion.angular_velocity;
  const bool slow =
      std::max(motion.velocity.norm(), motion.angular_velocity.norm() * reach) < limits::kStill * system.pace();
  const bool drifts = std::max(motion.drifted.norm(), motion.drifted_angular.norm() * reach) >
                      limits::kDrifts * system.pace() * limits::kStillRounds;
  motion.still = slow && !drifts ? motion.still + 1 : 0;
  if (motion.still % limits::kStillRounds == 0) motion.drifted = motion.drifted_angular = V3::Zero();
}

bool stands_still(const System& system, const Motion& motion) {
  return motion.position + motion.velocity * system.round() == motion.position && motion.angular_velocity == V3::Zero();
}

}  // namespace

void wake(System& system, Islands& islands) {
  std::vector<bool> awake(system.size(), false);
  for (std::size_t i = 0; i < system.size(); ++i)
    if (system.awake(i)) awake[islands.of(i)] = true;
  // A driven body wakes a sleeper that it touches, if it has moved since the sleeper fell asleep.
  for (const Contact& contact : system.contacts)
    for (const Index i : {contact.pair.a, contact.pair.b}) {
      const auto one = static_cast<std::size_t>(i),
                 other = static_cast<std::size_t>(contact.pair.a + contact.pair.b - i);
      if (system.members[one].driven && system.bodies[one].moved > system.bodies[other].moved)
        awake[islands.of(other)] = true;
    }
  for (std::size_t i = 0; i < system.size(); ++i)
    if (system.members[i].moves() && system.bodies[i].asleep && awake[islands.of(i)]) system.bodies[i].wake();
}

void rest(System& system, Islands& islands, const std::vector<ContactRow>& rows) {
  std::vector<bool> held(system.size(), false), wakeful(system.size(), false);
  for (const ContactRow& row : rows)
    if (row.impulse.normal > 0) held[row.pair.a] = held[row.pair.b] = true;
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (!system.awake(i)) continue;
    Motion& motion = system.bodies[i];
    watch(system, i, motion);
    const bool rests = motion.still >= limits::kStillRounds && (held[i] || stands_still(system, motion));
    if (!rests) wakeful[islands.of(i)] = true;
  }
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (!system.awake(i) || wakeful[islands.of(i)]) continue;
    Motion& motion = system.bodies[i];
    motion.asleep = true;
    motion.moved = system.moves;
    motion.velocity = motion.angular_velocity = V3::Zero();
  }
}

}  // namespace snug::physics
