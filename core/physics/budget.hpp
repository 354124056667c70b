// The energy that each island of bodies may use in a round, so that contacts never create any.
#pragma once

#include <vector>

#include "physics/impulses.hpp"
#include "physics/islands.hpp"

namespace snug::physics {

class Budgets {
 public:
  /// Before the rows are solved. All of system, islands and surface outlive it.
  Budgets(System& system, Islands& islands, const Surface& surface, const std::vector<ContactRow>& rows);
  /// Moves a body out of a wall all the way where the energy that an impact takes away pays for it; else part of the
  /// way, or not at all. Returns whether the body was moved.
  bool push_apart(const Shift& shift);
  /// After the rows are solved: takes back any energy that was gained, and remembers what slowing down before a bounce
  /// took.
  void settle();

 private:
  /// The kinetic energy of an island before gravity adds to it; where it bounces, with what slowing down for that took
  /// from it before.
  struct Budget {
    double before = 0, owed = 0;
    double kinetic = 0, falls = 0;  // after solving, and what its motion then takes from the field of gravity
    double pushed = 0;              // the share of that from pushing bodies apart
    bool bounces = false;
    [[nodiscard]] double may_spend() const { return before + (bounces ? owed : 0); }
    [[nodiscard]] double left() const { return may_spend() - pushed; }
    [[nodiscard]] bool is_exceeded() const { return kinetic - falls > left(); }
  };
  void sum_up();
  void bounce_less();
  [[nodiscard]] std::vector<double> parts_of_bounce(const std::vector<Budget>& with,
                                                    const std::vector<Motion>& bouncing);
  void take_back();
  [[nodiscard]] double part_before_walls(const Shift& shift) const;
  void remember();

  System& system_;
  Islands& islands_;
  const Surface& surface_;
  std::vector<Budget> budgets_;  // by the body that stands for the island
  std::vector<Motion> before_;   // these two only where an island bounces: it may have to be solved once more
  std::vector<ContactRow> unsolved_;
};

}  // namespace snug::physics
