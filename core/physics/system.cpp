#include "physics/system.hpp"

#include <algorithm>

#include "physics/limits.hpp"

namespace snug::physics {

bool System::any_awake() const {
  for (std::size_t i = 0; i < size(); ++i)
    if (awake(i)) return true;
  return false;
}

void System::place(std::size_t i, const V3& position, const Quaternion& orientation) {
  Motion& motion = bodies[i];
  motion.position = position;
  motion.orientation = orientation;
  motion.rotation = matrix_of(orientation);
  motion.moved = ++moves;
}

double System::pace() const { return (gravity == V3::Zero() ? limits::kUsualGravity : gravity.norm()) * round(); }

double System::thinner(const BodyPair& pair) const {
  const Member &a = members[pair.a], &b = members[pair.b];
  if (a.moves() != b.moves()) return (a.moves() ? a : b).shape.thinnest;
  return std::min(a.shape.thinnest, b.shape.thinnest);
}

double System::slop(const BodyPair& pair) const { return limits::kSlop * thinner(pair); }

double System::margin(std::size_t i) const {
  if (!solid) return 0;
  const double thinnest = members[i].shape.thinnest;
  return limits::kSlop * thinnest + std::min(bodies[i].velocity.norm() * round(), thinnest / 2);
}

double System::energy() const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i)
    if (members[i].moves())
      sum += kinetic_energy(members[i], bodies[i]) - members[i].mass * gravity.dot(bodies[i].position);
  return sum;
}

V3 by_inverse_inertia(const Member& member, const Motion& motion, const V3& v) {
  const V3 own = turned_back<double, 3>(motion.rotation, v);
  return turned<double, 3>(motion.rotation, own.cwiseProduct(member.inverse_inertia));
}

double kinetic_energy(const Member& member, const Motion& motion) {
  const V3 own = turned_back<double, 3>(motion.rotation, motion.angular_velocity);
  double sum = member.mass * motion.velocity.squaredNorm();
  for (int i = 0; i < 3; ++i)
    if (member.inverse_inertia[i] > 0) sum += own[i] * own[i] / member.inverse_inertia[i];
  return sum / 2;
}

}  // namespace snug::physics
