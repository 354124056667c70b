// Rigid bodies: their constant properties, their changing state, and what acts on all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/body_pair.hpp"
#include "geometry/pose.hpp"
#include "physics/shape.hpp"

namespace snug::physics {

/// The properties of a body that never change.
struct Member {
  std::string name;
  Shape shape;  // about its centre of mass
  bool fixed = false;
  bool driven = false;              // its pose is set from outside: neither velocities nor impulses move it
  double mass = 0;                  // 0: no impulse moves it
  V3 inverse_inertia = V3::Zero();  // about its own axes
  [[nodiscard]] bool moves() const { return mass > 0 && !driven; }
};

/// A body's state: where it is and how it moves.
struct Motion {
  V3 position = V3::Zero();
  Quaternion orientation;
  Matrix<double, 3> rotation = Matrix<double, 3>::Identity();  // of the orientation
  V3 velocity = V3::Zero();
  V3 angular_velocity = V3::Zero();
  int still = 0;                                          // number of rounds in a row in which it hardly moved
  V3 drifted = V3::Zero(), drifted_angular = V3::Zero();  // the sums of its velocities over those rounds
  bool asleep = false;
  std::uint64_t moved = 0;  // Moving::moves when it last moved or fell asleep

  void wake() {
    asleep = false;
    still = 0;
    drifted = drifted_angular = V3::Zero();
  }
};

[[nodiscard]] inline Pose<double, 3> pose_of(const Motion& motion) { return {motion.rotation, motion.position}; }

/// Two bodies that touch, or may touch before the next frame.
struct Contact {
  BodyPair pair;
  bool touching = false;
};

/// The impulse at a contact point in the last frame, with which the next frame starts.
struct Impulse {
  BodyPair pair;
  V3 on_a = V3::Zero(), on_b = V3::Zero();   // where, in each body's own frame
  double normal = 0, first = 0, second = 0;  // kg scene units / s
  double approach = 0;                       // the speed at which the bodies approached, until they bounce
  double owed = 0;                           // the energy lost by slowing down before that
};

/// Everything about rigid bodies that changes. A copy of it is a snapshot.
struct Moving {
  std::vector<Motion> bodies;
  std::vector<Contact> contacts;
  std::vector<Impulse> impulses;
  std::uint64_t moves = 0;  // how often a body was placed
};

struct System : Moving {
  std::vector<Member> members;  // of the bodies, in their order
  double step = 0;              // seconds a frame
  int rounds = 1;               // number of equal parts of a frame in which velocities move bodies
  V3 gravity = V3::Zero();      // scene units / s^2
  bool solid = false;           // bodies do not pass through each other

  [[nodiscard]] std::size_t size() const { return members.size(); }
  [[nodiscard]] const Moving& moving() const { return *this; }
  void restore(const Moving& earlier) { Moving::operator=(earlier); }
  /// Whether velocities move the body and it is not asleep.
  [[nodiscard]] bool awake(std::size_t i) const { return members[i].moves() && !bodies[i].asleep; }
  [[nodiscard]] bool any_awake() const;
  /// Turns and moves a body.
  void place(std::size_t i, const V3& position, const Quaternion& orientation);
  [[nodiscard]] double round() const { return step / rounds; }  // seconds
  /// The speed that gravity adds in a round, or usual gravity would: the unit in which speeds are judged.
  [[nodiscard]] double pace() const;
  /// The half thickness of the thinner body, or of the only one that moves, scene units: a floor may be as thin as
  /// paper.
  [[nodiscard]] double thinner(const BodyPair& pair) const;
  /// The penetration that is left as it is, scene units.
  [[nodiscard]] double slop(const BodyPair& pair) const;
  /// The distance from a body within which contacts are looked for, scene units.
  [[nodiscard]] double margin(std::size_t i) const;
  /// The kinetic and potential energy of all bodies that velocities move.
  [[nodiscard]] double energy() const;
};

/// (I^-1 in the world) v.
[[nodiscard]] V3 by_inverse_inertia(const Member& member, const Motion& motion, const V3& v);
[[nodiscard]] double kinetic_energy(const Member& member, const Motion& motion);

}  // namespace snug::physics
