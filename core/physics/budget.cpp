#include "physics/budget.hpp"

#include <algorithm>
#include <cmath>

#include "physics/limits.hpp"
#include "physics/sweep.hpp"

namespace snug::physics {

Budgets::Budgets(System& system, Islands& islands, const Surface& surface, const std::vector<ContactRow>& rows)
    : system_(system), islands_(islands), surface_(surface), budgets_(system.size()) {
  for (std::size_t i = 0; i < system.size(); ++i) {
    if (!system.awake(i)) continue;
    Motion motion = system.bodies[i];
    motion.velocity -= system.gravity * system.round();
    budgets_[islands.of(i)].before += kinetic_energy(system.members[i], motion);
  }
  for (const Impulse& held : system.impulses) budgets_[island_of(system, islands, held.pair)].owed += held.owed;
  bool bounces = false;
  for (const ContactRow& row : rows)
    if (row.target > 0) budgets_[island_of(system, islands, row.pair)].bounces = bounces = true;
  if (bounces) {
    before_ = system.bodies;
    unsolved_ = rows;
  }
}

/// A driven body pushes as hard and as far as it must. This is the fraction of that push that moves nothing into a
/// fixed body, which may have no contact yet.
double Budgets::part_before_walls(const Shift& shift) const {
  const Motion& motion = system_.bodies[shift.body];
  const Shape& shape = system_.members[shift.body].shape;
  double part = 1;
  for (std::size_t j = 0; j < system_.size(); ++j) {
    if (!system_.members[j].fixed) continue;
    const auto separation = [&](double at) {
      return separation_of(shape, {motion.rotation, motion.position + at * shift.by}, system_.members[j].shape,
                           pose_of(system_.bodies[j]));
    };
    const double start = separation(0);
    part = part_above(std::min(0.0, start), start, separation, shift.by.norm(), shape.thinnest / 4, part);
  }
  return part;
}

bool Budgets::push_apart(const Shift& shift) {
  Budget& budget = budgets_[islands_.of(shift.body)];
  const Motion& motion = system_.bodies[shift.body];
  const double work = shift.driven ? 0 : -system_.members[shift.body].mass * system_.gravity.dot(shift.by);
  const auto affords = [&](double part) { return shift.driven || budget.pushed + part * work <= budget.may_spend(); };
  double part = shift.driven || (shift.out_of_wall && !budget.bounces && affords(1)) ? 1 : limits::kMended;
  if (!affords(part)) return false;
  if (shift.driven) part = part_before_walls(shift);
  budget.pushed += part * work;
  system_.place(shift.body, motion.position + part * shift.by, motion.orientation);
  return true;
}

void Budgets::settle() {
  sum_up();
  if (std::any_of(budgets_.begin(), budgets_.end(),
                  [](const Budget& budget) { return budget.bounces && budget.is_exceeded(); }))
    bounce_less();
  take_back();
  remember();
}

void Budgets::sum_up() {
  for (Budget& budget : budgets_) budget.kinetic = budget.falls = 0;
  for (std::size_t i = 0; i < system_.size(); ++i) {
    if (!system_.awake(i)) continue;
    Budget& budget = budgets_[islands_.of(i)];
    budget.kinetic += kinetic_energy(system_.members[i], system_.bodies[i]);
    budget.falls += system_.members[i].mass * system_.round() * system_.gravity.dot(system_.bodies[i].velocity);
  }
}

/// Restitution at each contact point by itself can return more energy than all bodies brought. With velocities v1,
/// which bounce, and v0, which do not and never gain, an island gets v0 + s (v1 - v0): the greatest s for which it uses
/// no more than it may. The constraints that keep bodies apart are linear, so they hold in between as well.
void Budgets::bounce_less() {
  const std::vector<Budget> with = budgets_;
  std::vector<Motion> bouncing = system_.bodies;
  const std::vector<Impulse> impulses = system_.impulses;
  std::vector<Motion>& bodies = system_.bodies;
  for (std::size_t i = 0; i < system_.size(); ++i) {
    bodies[i].velocity = before_[i].velocity;
    bodies[i].angular_velocity = before_[i].angular_velocity;
  }
  remove_restitution(system_, unsolved_);
  solve(system_, unsolved_, surface_);
  sum_up();
  for (std::size_t i = 0; i < system_.size(); ++i) {
    bouncing[i].velocity -= bodies[i].velocity;
    bouncing[i].angular_velocity -= bodies[i].angular_velocity;
  }
  const std::vector<double> parts = parts_of_bounce(with, bouncing);
  for (std::size_t i = 0; i < system_.size(); ++i) {
    const double part = parts[islands_.of(i)];
    bodies[i].velocity += part * bouncing[i].velocity;
    bodies[i].angular_velocity += part * bouncing[i].angular_velocity;
  }
  for (std::size_t k = 0; k < impulses.size(); ++k) {
    Impulse& impulse = system_.impulses[k];
    const double part = parts[island_of(system_, islands_, impulse.pair)];
    impulse.normal += part * (impulses[k].normal - impulse.normal);
    impulse.first += part * (impulses[k].first - impulse.first);
    impulse.second += part * (impulses[k].second - impulse.second);
  }
  sum_up();
}

/// The s of each island: 1, or the greater root of gained s^2 + linear s = what v0 left, where gained is the energy of
/// v1 - v0.
std::vector<double> Budgets::parts_of_bounce(const std::vector<Budget>& with, const std::vector<Motion>& bouncing) {
  std::vector<double> gained(system_.size()), parts(system_.size(), 1);
  for (std::size_t i = 0; i < system_.size(); ++i)
    if (system_.awake(i)) gained[islands_.of(i)] += kinetic_energy(system_.members[i], bouncing[i]);
  for (std::size_t i = 0; i < system_.size(); ++i) {
    if (!with[i].is_exceeded()) continue;
    const double spent = budgets_[i].kinetic - budgets_[i].falls, left = budgets_[i].left() - spent;
    const double linear = (with[i].kinetic - with[i].falls) - spent - gained[i];
    const bool none = left <= 0 || gained[i] <= 0;
    parts[i] =
        none ? 0 : std::clamp((std::sqrt(linear * linear + 4 * gained[i] * left) - linear) / (2 * gained[i]), 0.0, 1.0);
  }
  return parts;
}

/// Exact impulses without restitution take energy away. These are not quite exact, so an island may end with a trace
/// more than it had: then all of it is slowed down by just so much, which moves no body into another. With its
/// velocities times s, s^2 kinetic - s falls = what is left.
void Budgets::take_back() {
  for (std::size_t i = 0; i < system_.size(); ++i) {
    const Budget& budget = budgets_[islands_.of(i)];
    if (!system_.awake(i) || !budget.is_exceeded()) continue;
    const double root = std::sqrt(std::max(0.0, budget.falls * budget.falls + 4 * budget.kinetic * budget.left()));
    const double part = budget.kinetic > 0 ? std::clamp((budget.falls + root) / (2 * budget.kinetic), 0.0, 1.0) : 1;
    system_.bodies[i].velocity *= part;
    system_.bodies[i].angular_velocity *= part;
  }
}

/// The energy that an island lost is owed to the first of its contacts that have yet to bounce.
void Budgets::remember() {
  for (Impulse& impulse : system_.impulses) {
    if (impulse.approach <= 0) continue;
    Budget& budget = budgets_[island_of(system_, islands_, impulse.pair)];
    impulse.owed = std::max(0.0, budget.before + budget.owed - budget.pushed - (budget.kinetic - budget.falls));
    budget = {};
  }
}

}  // namespace snug::physics
