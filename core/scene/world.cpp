#include "scene/world.hpp"

#include "geometry/tolerance.hpp"
#include "number/bits.hpp"
#include "number/fnv.hpp"
#include "scene/shape.hpp"

namespace snug::scene {
namespace {

/// The quaternion of a rotation matrix, computed from the largest of its four squares.
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
  void add(const V3& v) {
    for (int axis = 0; axis < 3; ++axis) add(v[axis]);
  }
  void add_all(const auto&... all) { (add(all), ...); }
};

}  // namespace

std::uint64_t World::hash() const {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(state.frame));
  for (const Motion& body : bodies) {
    const Quaternion& q = body.orientation;
    hash.add_all(body.position, body.velocity, body.angular_velocity, q.w, q.x, q.y, q.z);
    hash.add_all(body.drifted, body.drifted_angular);
    hash.add(static_cast<std::uint64_t>(body.still) * 2 + (body.asleep ? 1 : 0));
  }
  for (const physics::Impulse& impulse : impulses) {
    hash.add_all(impulse.on_a, impulse.on_b, impulse.normal, impulse.first, impulse.second, impulse.approach,
                 impulse.owed);
  }
  return hash.value();
}

Aabb<double, 3> with_room(const Aabb<double, 3>& aabb, double margin) {
  const double room =
      margin + tolerance::kPlaced<double> * (aabb.min.cwiseAbs().maxCoeff() + aabb.max.cwiseAbs().maxCoeff());
  return {aabb.min - V3::Constant(room), aabb.max + V3::Constant(room)};
}

World world_of(const Declaration& declaration) {
  World world;
  world.step = declaration.step;
  world.seed = declaration.seed;
  for (const Body& body : declaration.bodies) {
    Centered own = centered(body.shape);
    const Quaternion declared = normalized(body.orientation);
    Member member{
        .name = body.name, .shape = std::move(own.shape), .fixed = body.fixed, .mass = body.fixed ? 0 : body.mass};
    const V3 inertia = member.mass * inertia_of(member.shape);
    for (int i = 0; i < 3; ++i) member.inverse_inertia[i] = inertia[i] > 0 ? 1 / inertia[i] : 0;
    world.members.push_back(std::move(member));
    world.bodies.push_back({.velocity = body.fixed ? V3(V3::Zero()) : body.velocity,
                            .angular_velocity = body.fixed ? V3(V3::Zero()) : body.angular_velocity});
    const V3 position = body.position + turned<double, 3>(matrix_of(declared), own.center);
    world.place(world.size() - 1, position, normalized(declared * quaternion_of(own.axes)));
  }
  world.state.funnel.all = static_cast<std::int64_t>(world.size()) * (static_cast<std::int64_t>(world.size()) - 1) / 2;
  world.state.volumes.resize(world.size());
  world.state.changed(Slot::kPoses);
  world.state.changed(Slot::kVelocities);
  return world;
}

}  // namespace snug::scene
