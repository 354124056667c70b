#include "scene/world.hpp"

#include <algorithm>

#include "number/bits.hpp"
#include "number/fnv.hpp"
#include "scene/limits.hpp"

namespace snug::scene {
namespace {

/// The quaternion of a rotation matrix, by the largest of its four squares.
/// Source: S. W. Shepperd, "Quaternion from rotation matrix", 1978.
Quaternion quaternion_of(const Matrix<double, 3>& m) {
  const double x = m(0, 0), y = m(1, 1), z = m(2, 2);
  if (x + y + z > 0) return normalized({1 + x + y + z, m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)});
  if (x >= y && x >= z) return normalized({m(2, 1) - m(1, 2), 1 + x - y - z, m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)});
  if (y >= z) return normalized({m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), 1 + y - z - x, m(1, 2) + m(2, 1)});
  return normalized({m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), 1 + z - x - y});
}

struct Hash : Fnv1a {
  void add(std::uint64_t bits) { add_bits(bits); }
  void add(double number) { add_bits(bits_of(number)); }
  void add(const V3& v) { add(v[0]), add(v[1]), add(v[2]); }
};

}  // namespace

bool World::any_awake() const {
  for (std::size_t i = 0; i < size(); ++i)
    if (awake(i)) return true;
  return false;
}

void World::place(std::size_t i, const V3& position, const Quaternion& orientation) {
  Motion& motion = state.bodies[i];
  motion.position = position;
  motion.orientation = orientation;
  motion.rotation = matrix_of(orientation);
  motion.moved = state.revision(Slot::kPoses) + 1;
}

double World::pace() const { return (gravity == V3::Zero() ? limits::kUsualGravity : gravity.norm()) * round(); }

double World::thinner(const Pair& pair) const {
  const Member &a = members[pair.a], &b = members[pair.b];
  if (a.moves() != b.moves()) return (a.moves() ? a : b).shape.thinnest;
  return std::min(a.shape.thinnest, b.shape.thinnest);
}

double World::slop(const Pair& pair) const { return limits::kSlop * thinner(pair); }

double World::margin(std::size_t i) const {
  if (!solid) return 0;
  const double thinnest = members[i].shape.thinnest;
  return limits::kSlop * thinnest + std::min(state.bodies[i].velocity.norm() * round(), thinnest / 2);
}

double World::energy() const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i)
    if (members[i].moves())
      sum += kinetic_energy(members[i], state.bodies[i]) - members[i].mass * gravity.dot(state.bodies[i].position);
  return sum;
}

std::uint64_t World::hash() const {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(state.frame));
  for (const Motion& body : state.bodies) {
    hash.add(body.position), hash.add(body.velocity), hash.add(body.turning);
    const Quaternion& q = body.orientation;
    hash.add(q.w), hash.add(q.x), hash.add(q.y), hash.add(q.z);
    hash.add(body.drifted), hash.add(body.drifted_turning);
    hash.add(static_cast<std::uint64_t>(body.still) * 2 + (body.asleep ? 1 : 0));
  }
  for (const Impulse& impulse : state.impulses) {
    hash.add(impulse.on_a), hash.add(impulse.on_b);
    hash.add(impulse.normal), hash.add(impulse.first), hash.add(impulse.second), hash.add(impulse.approach),
        hash.add(impulse.owed);
  }
  return hash.value();
}

World world_of(const Declaration& declaration) {
  World world{.step = declaration.step, .seed = declaration.seed};
  for (const Body& body : declaration.bodies) {
    Centered own = centered(body.shape);
    const Quaternion declared = normalized(body.orientation);
    Member member{
        .name = body.name, .shape = std::move(own.shape), .fixed = body.fixed, .mass = body.fixed ? 0 : body.mass};
    const V3 inertia = member.mass * inertia_of(member.shape);
    for (int i = 0; i < 3; ++i) member.inverse_inertia[i] = inertia[i] > 0 ? 1 / inertia[i] : 0;
    world.members.push_back(std::move(member));
    world.state.bodies.push_back({.velocity = body.fixed ? V3(V3::Zero()) : body.velocity,
                                  .turning = body.fixed ? V3(V3::Zero()) : body.turning});
    const V3 position = body.position + turned<double, 3>(matrix_of(declared), own.center);
    world.place(world.size() - 1, position, normalized(declared * quaternion_of(own.axes)));
  }
  world.state.funnel.all = static_cast<std::int64_t>(world.size()) * (static_cast<std::int64_t>(world.size()) - 1) / 2;
  world.state.volumes.resize(world.size());
  world.state.changed(Slot::kPoses), world.state.changed(Slot::kVelocities);
  return world;
}

V3 by_inverse_inertia(const Member& member, const Motion& motion, const V3& v) {
  const V3 own = turned_back<double, 3>(motion.rotation, v);
  return turned<double, 3>(motion.rotation, own.cwiseProduct(member.inverse_inertia));
}

double kinetic_energy(const Member& member, const Motion& motion) {
  const V3 own = turned_back<double, 3>(motion.rotation, motion.turning);
  double sum = member.mass * motion.velocity.squaredNorm();
  for (int i = 0; i < 3; ++i)
    if (member.inverse_inertia[i] > 0) sum += own[i] * own[i] / member.inverse_inertia[i];
  return sum / 2;
}

}  // namespace snug::scene
