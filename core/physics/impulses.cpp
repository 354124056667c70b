#include "physics/impulses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "physics/limits.hpp"

namespace snug::physics {
namespace {

const Motion& motion_of(const System& system, Index i) { return system.bodies[i]; }
const Member& member_of(const System& system, Index i) { return system.members[i]; }
double inverse_mass(const System& system, Index i) {
  const Member& member = member_of(system, i);
  return member.moves() ? 1 / member.mass : 0;
}

V3 velocity_at(const System& system, Index i, const V3& arm) {
  const Motion& motion = motion_of(system, i);
  if (!member_of(system, i).moves()) return V3::Zero();
  return motion.velocity + motion.angular_velocity.cross(arm);
}

V3 relative_velocity(const System& system, const ContactRow& row) {
  return velocity_at(system, row.pair.b, row.arm_b) - velocity_at(system, row.pair.a, row.arm_a);
}

/// The velocity in a direction that a unit impulse along it gives to a point of the body.
double inverse_effective_mass(const System& system, Index i, const V3& arm, const V3& way) {
  const Member& member = member_of(system, i);
  if (!member.moves()) return 0;
  const V3 torque_arm = arm.cross(way);
  return 1 / member.mass + torque_arm.dot(by_inverse_inertia(member, motion_of(system, i), torque_arm));
}

double effective_mass(const System& system, const ContactRow& row, const V3& way) {
  const double sum = inverse_effective_mass(system, row.pair.a, row.arm_a, way) +
                     inverse_effective_mass(system, row.pair.b, row.arm_b, way);
  return sum > 0 ? 1 / sum : 0;
}

void apply_impulse(System& system, Index i, const V3& arm, const V3& impulse) {
  const Member& member = member_of(system, i);
  if (!member.moves()) return;
  Motion& motion = system.bodies[i];
  motion.velocity += impulse / member.mass;
  motion.angular_velocity += by_inverse_inertia(member, motion, arm.cross(impulse));
}

void apply_impulse(System& system, const ContactRow& row, const V3& impulse) {
  apply_impulse(system, row.pair.a, row.arm_a, -impulse);
  apply_impulse(system, row.pair.b, row.arm_b, impulse);
}

/// The impulses of the pair in the last round.
std::vector<Impulse> held_by(const System& system, const BodyPair& pair) {
  const auto before = [](const Impulse& impulse, const BodyPair& wanted) { return impulse.pair < wanted; };
  const auto from = std::lower_bound(system.impulses.begin(), system.impulses.end(), pair, before);
  auto to = from;
  while (to != system.impulses.end() && to->pair == pair) ++to;
  return {from, to};
}

/// Returns and removes the cached impulse that lies nearest on one body or the other, if one is near enough to be the
/// same point.
std::optional<Impulse> take_nearest(std::vector<Impulse>& held, const Impulse& point, double most) {
  const auto apart = [&](const Impulse& one) {
    return std::min((one.on_a - point.on_a).norm(), (one.on_b - point.on_b).norm());
  };
  const auto nearest = std::min_element(held.begin(), held.end(),
                                        [&](const Impulse& x, const Impulse& y) { return apart(x) < apart(y); });
  if (nearest == held.end() || apart(*nearest) > most) return std::nullopt;
  const Impulse found = *nearest;
  held.erase(nearest);
  return found;
}

/// Two directions perpendicular to the normal, always the same for the same normal.
void span_plane(ContactRow& row) {
  int least = 0;
  row.normal.cwiseAbs().minCoeff(&least);
  row.first = row.normal.cross(V3::Unit(least));
  row.first /= row.first.norm();
  row.second = row.normal.cross(row.first);
}

ContactRow row_of(const System& system, const BodyPair& pair, const V3& normal, const ManifoldPoint& point) {
  ContactRow row{
      .pair = pair, .normal = normal, .separation = point.separation, .slop = system.slop(pair), .impulse = {pair}};
  row.against_wall = !member_of(system, pair.a).moves() || !member_of(system, pair.b).moves();
  span_plane(row);
  row.arm_a = point.position - motion_of(system, pair.a).position;
  row.arm_b = point.position - motion_of(system, pair.b).position;
  row.impulse.on_a = turned_back<double, 3>(motion_of(system, pair.a).rotation, row.arm_a);
  row.impulse.on_b = turned_back<double, 3>(motion_of(system, pair.b).rotation, row.arm_b);
  row.normal_mass = effective_mass(system, row, row.normal);
  row.first_mass = effective_mass(system, row, row.first);
  row.second_mass = effective_mass(system, row, row.second);
  return row;
}

/// The relative speed along the normal that gravity gave the pair in this frame.
double fallen(const System& system, const ContactRow& row) {
  const double share =
      (member_of(system, row.pair.b).moves() ? 1.0 : 0.0) - (member_of(system, row.pair.a).moves() ? 1.0 : 0.0);
  return share * system.round() * system.gravity.dot(row.normal);
}

/// The bodies may close the gap between them, and no more.
double still_target(const System& system, const ContactRow& row) {
  return row.separation > 0 ? -row.separation / system.round() : 0;
}

/// The greatest speed at which the bodies may still approach there; once they touch, the speed at which they separate
/// again. The approach speed is remembered for the round in which they meet, because the constraint that keeps them
/// from passing through slows them down before. It is the speed at the moment they meet, without what gravity still
/// adds by the end of the round, or a ball would bounce too high.
void aim(const System& system, ContactRow& row, const Surface& surface, double approach_before) {
  const double seconds = system.round(), speed = -relative_velocity(system, row).dot(row.normal);
  const double part = speed > 0 ? std::clamp(row.separation / (speed * seconds), 0.0, 1.0) : 1;
  const double own = speed + std::min(0.0, fallen(system, row)) * (1 - part), coming = std::max(own, approach_before);
  const auto quick = [&](double comes) { return comes > limits::kRestitutionThreshold * system.pace(); };
  if (row.separation > row.slop) {
    row.target = -row.separation / seconds;
    row.impulse.approach = quick(own) && own * seconds > row.separation ? own : 0;
    return;
  }
  // Gravity acts for a round before the body goes up: so it rises as high as it fell from, and no higher.
  row.target = quick(coming) ? std::max(0.0, surface.restitution * coming + std::min(0.0, fallen(system, row)))
                             : still_target(system, row);
}

}  // namespace

std::vector<ContactRow> rows_of(const System& system, const Surface& surface) {
  std::vector<ContactRow> rows;
  for (const Contact& contact : system.contacts) {
    const std::size_t a = contact.pair.a, b = contact.pair.b;
    if (!system.awake(a) && !system.awake(b)) continue;
    const Manifold manifold = manifold_of(system.members[a].shape, pose_of(system.bodies[a]), system.members[b].shape,
                                          pose_of(system.bodies[b]), system.margin(a) + system.margin(b));
    std::vector<Impulse> held = held_by(system, contact.pair);
    const bool lone = held.size() == 1 && manifold.count == 1;  // a rolling ball's contact moves
    const double most =
        lone ? std::numeric_limits<double>::infinity() : limits::kSamePoint * system.thinner(contact.pair);
    double approach = 0;
    for (const Impulse& one : held) approach = std::max(approach, one.approach);
    for (const ManifoldPoint& point : manifold.all()) {
      ContactRow row = row_of(system, contact.pair, manifold.normal, point);
      if (const auto before = take_nearest(held, row.impulse, most)) {
        row.impulse.normal = before->normal;
        row.impulse.first = before->first;
        row.impulse.second = before->second;
      }
      aim(system, row, surface, approach);
      rows.push_back(row);
    }
  }
  return rows;
}

namespace {

/// The larger the ratio of masses, the more iterations; and the most where there are no impulses yet, as at the start,
/// because nothing would pay for lifting a stack that sinks then.
int most_iterations(const System& system, const std::vector<ContactRow>& rows) {
  if (system.impulses.empty()) return limits::kMostIterations;
  double ratio = 1;
  for (const ContactRow& row : rows) {
    if (row.against_wall) continue;
    const double a = member_of(system, row.pair.a).mass, b = member_of(system, row.pair.b).mass;
    ratio = std::max({ratio, a / b, b / a});
  }
  return static_cast<int>(std::min(limits::kIterations * std::sqrt(ratio), 1.0 * limits::kMostIterations));
}

/// Corrects the velocities at one point. Returns the correction along the normal.
double solve_point(System& system, ContactRow& row, const Surface& surface) {
  const double most = surface.friction * row.impulse.normal;
  const V3 sliding = relative_velocity(system, row);
  double first = row.impulse.first - row.first_mass * sliding.dot(row.first),
         second = row.impulse.second - row.second_mass * sliding.dot(row.second);
  const double length = std::sqrt(first * first + second * second);  // hypot gives other bits on other platforms
  const double part = length > most ? most / length : 1;
  first *= part;
  second *= part;
  apply_impulse(system, row, row.first * (first - row.impulse.first) + row.second * (second - row.impulse.second));
  row.impulse.first = first;
  row.impulse.second = second;
  const double before = row.impulse.normal;
  row.impulse.normal =
      std::max(0.0, before - row.normal_mass * (relative_velocity(system, row).dot(row.normal) - row.target));
  apply_impulse(system, row, row.normal * (row.impulse.normal - before));
  return row.normal_mass > 0 ? std::abs(row.impulse.normal - before) / row.normal_mass : 0;
}

}  // namespace

void remove_restitution(const System& system, std::vector<ContactRow>& rows) {
  for (ContactRow& row : rows)
    if (row.target > 0) row.target = still_target(system, row);
}

void solve(System& system, std::vector<ContactRow>& rows, const Surface& surface) {
  for (const ContactRow& row : rows)
    apply_impulse(system, row,
                  row.impulse.normal * row.normal + row.impulse.first * row.first + row.impulse.second * row.second);
  double wrong = std::numeric_limits<double>::infinity();
  const int most = most_iterations(system, rows);
  for (int iteration = 0; iteration < most && wrong > limits::kSettled * system.pace(); ++iteration) {
    wrong = 0;
    for (ContactRow& row : rows) wrong = std::max(wrong, solve_point(system, row, surface));
  }
  // Bodies that do not move come last: a light body between one and a heavy body would be pushed through it.
  for (ContactRow& row : rows)
    if (row.against_wall) solve_point(system, row, surface);
  system.impulses.clear();
  for (const ContactRow& row : rows) system.impulses.push_back(row.impulse);
}

namespace {

/// The contact points of each body with bodies that do not move.
std::vector<std::vector<const ContactRow*>> walls_of(const System& system, const std::vector<ContactRow>& rows) {
  std::vector<std::vector<const ContactRow*>> walls(system.size());
  for (const ContactRow& row : rows)
    if (row.against_wall) walls[member_of(system, row.pair.a).moves() ? row.pair.a : row.pair.b].push_back(&row);
  return walls;
}

/// If two push a body, the firmer one moves it: fixed bodies are firmer than driven ones, and those than all others.
int firmness(const Member& member) {
  if (member.moves()) return 0;
  return member.fixed ? 2 : 1;
}

/// The part of a unit direction along which the pusher may shift a body: none of it into a firmer body nearby. All of
/// it where the shift is short and the pusher moves as well: bodies that do not move push back in the same round, and
/// stacks share the work.
V3 free_way(const System& system, std::span<const ContactRow* const> walls, Index body, Index pusher, V3 way,
            double far) {
  if (member_of(system, pusher).moves() && far < limits::kShared * member_of(system, body).shape.thinnest) return way;
  for (const ContactRow* row : walls) {
    const bool first = row->pair.a == body;
    const Member& wall = member_of(system, first ? row->pair.b : row->pair.a);
    const V3 into = first ? row->normal : V3(-row->normal);
    if (row->separation < far && firmness(wall) > firmness(member_of(system, pusher)))
      way -= std::max(0.0, way.dot(into)) * into;
  }
  if (way.squaredNorm() < limits::kLeastFree) way = V3::Zero();
  return way;
}

}  // namespace

std::vector<Shift> shifts_apart(const System& system, const std::vector<ContactRow>& rows) {
  std::vector<Shift> shifts;
  const auto walls = walls_of(system, rows);
  for (std::size_t i = 0; i < rows.size();) {
    const ContactRow* deepest = &rows[i];
    const BodyPair pair = rows[i].pair;
    for (; i < rows.size() && rows[i].pair == pair; ++i)
      if (rows[i].separation < deepest->separation) deepest = &rows[i];
    const double depth = -deepest->separation - deepest->slop;
    if (depth <= 0) continue;
    const auto free = [&](Index body, Index pusher, const V3& way) {
      return V3(free_way(system, walls[body], body, pusher, way, depth));
    };
    const V3 way_a = free(pair.a, pair.b, -deepest->normal), way_b = free(pair.b, pair.a, deepest->normal);
    const double of_a = inverse_mass(system, pair.a), of_b = inverse_mass(system, pair.b);
    const double yields_a = of_a * way_a.squaredNorm(), yields_b = of_b * way_b.squaredNorm();
    if (yields_a + yields_b == 0) continue;
    const double share = depth / (yields_a + yields_b);
    if (yields_a > 0)
      shifts.push_back(
          {static_cast<std::size_t>(pair.a), way_a * (share * of_a), yields_b == 0, member_of(system, pair.b).driven});
    if (yields_b > 0)
      shifts.push_back(
          {static_cast<std::size_t>(pair.b), way_b * (share * of_b), yields_a == 0, member_of(system, pair.a).driven});
  }
  return shifts;
}

}  // namespace snug::physics
