// Bodies in contact with each other, which share an energy budget and sleep and wake together.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "physics/system.hpp"

namespace snug::physics {

/// A forest of disjoint sets: the body with the lowest index stands for its island.
/// Source: R. Tarjan, "Efficiency of a good but not linear set union algorithm", 1975.
class Islands {
 public:
  explicit Islands(std::size_t bodies) : parents_(bodies) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t of(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parents_;
};

/// The islands of moving bodies that have contacts with each other.
[[nodiscard]] inline Islands islands_of(const System& system) {
  Islands islands(system.size());
  for (const Contact& contact : system.contacts) {
    const std::size_t a = contact.pair.a, b = contact.pair.b;
    if (system.members[a].moves() && system.members[b].moves()) islands.join(a, b);
  }
  return islands;
}

/// The island of a pair in which at least one body moves.
[[nodiscard]] inline std::size_t island_of(const System& system, Islands& islands, const BodyPair& pair) {
  const std::size_t a = pair.a;
  return islands.of(system.members[a].moves() ? a : static_cast<std::size_t>(pair.b));
}

}  // namespace snug::physics
