// What each island of bodies may spend in a round, so that contacts never make energy.
#pragma once

#include <vector>

#include "physics/impulses.hpp"
#include "physics/islands.hpp"

namespace snug::physics {

class Budgets {
 public:
  /// Before the rows are solved. All of system, islands and surface outlive it.
  Budgets(System& system, Islands& islands, const Surface& surface, const std::vector<ContactRow>& rows);
  /// Out of a wall all of the way, where what an impact takes away pays for it; else a part of it, or none. Whether the
  /// body was moved.
  bool push_apart(const Shift& shift);
  /// After the rows are solved: what was spent too much is taken back, and what slowing down for a bounce took is
  /// remembered.
  void settle();

 private:
  /// The kinetic energy with which an island came in, before gravity added to it; and where it bounces, what slowing
  /// down for that took from it before.
  struct Budget {
    double before = 0, owed = 0;
    double kinetic = 0, falls = 0;  // as it goes out, and what its motion then takes from the field of gravity
    double pushed = 0;              // what pushing bodies apart gave to that
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
  std::vector<Budget> budgets_;  // by the body that an island goes by
  std::vector<Motion> before_;   // these two only where some island bounces: it may have to be solved once more
  std::vector<ContactRow> unsolved_;
};

}  // namespace snug::physics
