#include "physics/start.hpp"

#include <algorithm>
#include <cmath>

#include "physics/limits.hpp"
#include "physics/manifold.hpp"

namespace snug::physics {
namespace {

/// What separation_of returns; for bodies that are surely apart, a bound.
double separation_at_start(const System& system, std::size_t i, std::size_t j) {
  const double between = (system.bodies[j].position - system.bodies[i].position).norm();
  if (const double bound = between - system.members[i].shape.reach - system.members[j].shape.reach; bound > 0)
    return bound;
  return separation_of(system.members[i].shape, pose_of(system.bodies[i]), system.members[j].shape,
                       pose_of(system.bodies[j]));
}

}  // namespace

const Member* thinnest_of(const System& system) {
  const Member* thinnest = nullptr;
  for (const Member& member : system.members)
    if (member.moves() && (thinnest == nullptr || member.shape.thinnest < thinnest->shape.thinnest)) thinnest = &member;
  return thinnest;
}

double rounds_for(const System& system, const Member* thinnest) {
  double longest = limits::kLongestRound;
  if (thinnest != nullptr && system.gravity != V3::Zero())
    longest = std::min(longest, std::sqrt(limits::kFallInRound * thinnest->shape.thinnest / system.gravity.norm()));
  return std::ceil(system.step / longest);
}

const Member* too_fast(const System& system) {
  for (std::size_t i = 0; i < system.size(); ++i) {
    const Member& member = system.members[i];
    const Motion& motion = system.bodies[i];
    const double angular_velocity =
        member.shape.kind == Shape::Kind::kSphere ? 0 : motion.angular_velocity.norm() * member.shape.reach;
    const bool fast =
        (motion.velocity.norm() + angular_velocity) * system.step > limits::kMostCrossed * 2 * member.shape.thinnest;
    if (member.moves() && fast) return &member;
  }
  return nullptr;
}

std::pair<const Member*, const Member*> first_inside(const System& system) {
  for (std::size_t j = 0; j < system.size(); ++j)
    for (std::size_t i = 0; system.members[j].fixed && i < system.size(); ++i) {
      const Member &body = system.members[i], &wall = system.members[j];
      if (body.moves() && separation_at_start(system, i, j) < -limits::kDeepestStart * body.shape.thinnest)
        return {&body, &wall};
    }
  return {nullptr, nullptr};
}

std::vector<Contact> contacts_at_start(const System& system) {
  std::vector<Contact> contacts;
  for (Index a = 0; a < static_cast<Index>(system.size()); ++a)
    for (Index b = a + 1; b < static_cast<Index>(system.size()); ++b) {
      const std::size_t i = a, j = b;
      if (!system.members[i].moves() && !system.members[j].moves()) continue;
      const double separation = separation_at_start(system, i, j);
      if (separation <= system.slop({a, b})) contacts.push_back({{a, b}, separation <= 0});
    }
  return contacts;
}

}  // namespace snug::physics
