#include "physics/advance.hpp"

#include <algorithm>
#include <cmath>

#include "physics/limits.hpp"
#include "physics/manifold.hpp"
#include "physics/sweep.hpp"

namespace snug::physics {
namespace {

/// Rotates the body by its angular velocity. A body that tumbles keeps its angular momentum, not its axis; the energy
/// that Euler's step would add is taken back.
void turn_body(System& system, std::size_t i, double seconds) {
  const Member& member = system.members[i];
  Motion& motion = system.bodies[i];
  if (motion.angular_velocity == V3::Zero()) return;
  const double before = kinetic_energy(member, motion);
  V3 momentum = turned_back<double, 3>(motion.rotation, motion.angular_velocity);
  for (int k = 0; k < 3; ++k) momentum[k] = member.inverse_inertia[k] > 0 ? momentum[k] / member.inverse_inertia[k] : 0;
  const V3 in_world = turned<double, 3>(motion.rotation, momentum);
  system.place(i, motion.position,
               normalized(quaternion_about(motion.angular_velocity, motion.angular_velocity.norm() * seconds) *
                          motion.orientation));
  if (in_world == V3::Zero()) return;  // nothing resists its turning: a point
  motion.angular_velocity = by_inverse_inertia(member, motion, in_world);
  const double linear = member.mass * motion.velocity.squaredNorm() / 2;
  const double after = kinetic_energy(member, motion);
  if (after > before && after > linear)
    motion.angular_velocity *= std::sqrt(std::max(0.0, before - linear) / (after - linear));
}

/// Takes back the speed that gravity gave for the rest of a path that a contact cut short.
void give_back(const System& system, Motion& motion, double seconds) {
  const double square = motion.velocity.squaredNorm();
  if (square > 0)
    motion.velocity *= std::sqrt(std::max(0.0, 1 - 2 * seconds * system.gravity.dot(motion.velocity) / square));
}

/// The fraction of its path in this round that the body covers before it touches another. Its rotation counts: a body
/// that falls over about a vertex moves on, although straight ahead that vertex is in the way.
double free_part(const System& system, std::size_t i) {
  const Motion& motion = system.bodies[i];
  const Shape& shape = system.members[i].shape;
  const V3 way = motion.velocity * system.round();
  const double angle = shape.kind == Shape::Kind::kSphere ? 0 : motion.angular_velocity.norm() * system.round();
  const double length = way.norm() + angle * shape.reach;
  if (length <= shape.thinnest / 2) return 1;
  const auto pose_at = [&](double part) -> Pose<double, 3> {
    if (angle == 0) return {motion.rotation, motion.position + way * part};
    return {matrix_of(normalized(quaternion_about(motion.angular_velocity, angle * part) * motion.orientation)),
            motion.position + way * part};
  };
  double part = 1;
  for (std::size_t j = 0; j < system.size(); ++j) {
    const Motion& met = system.bodies[j];
    const Shape& other = system.members[j].shape;
    const V3 to = met.position - motion.position;
    const double along = way.squaredNorm() > 0 ? std::clamp(to.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    if (j == i || (to - along * way).norm() > shape.reach + other.reach) continue;
    const auto separation = [&](double at) { return separation_of(shape, pose_at(at), other, pose_of(met)); };
    // Contacts hold back a body that already touches: it may go in this deep, or stay as deep as it is.
    const double start = separation(0),
                 slop = system.slop({static_cast<Index>(std::min(i, j)), static_cast<Index>(std::max(i, j))});
    const double deepest = start > slop ? 0 : std::min(-limits::kDeepest * shape.thinnest, start - slop / 8);
    part = part_above(deepest, start, separation, length, shape.thinnest / 4, part);
  }
  return part;
}

}  // namespace

bool advance(System& system) {
  bool moved = false;
  for (std::size_t i = 0; i < system.size(); ++i) {
    Motion& motion = system.bodies[i];
    if (!system.awake(i) || (motion.velocity == V3::Zero() && motion.angular_velocity == V3::Zero())) continue;
    moved = true;
    const double seconds = system.round(), part = system.solid ? free_part(system, i) : 1;
    system.place(i, motion.position + motion.velocity * (seconds * part), motion.orientation);
    if (part < 1) give_back(system, motion, seconds * (1 - part));
    turn_body(system, i, seconds * part);
  }
  return moved;
}

bool stands_still(const System& system) {
  for (std::size_t i = 0; i < system.size(); ++i)
    if (system.awake(i) && (system.bodies[i].velocity != V3::Zero() || system.bodies[i].angular_velocity != V3::Zero()))
      return false;
  return true;
}

}  // namespace snug::physics
