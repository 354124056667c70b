// Finds how far along its path a body can go, by conservative advancement.
#pragma once

#include <algorithm>

#include "physics/limits.hpp"

namespace snug::physics {

/// The greatest fraction of a path up to which the separation stays at or above the deepest allowed. start: the
/// separation at fraction 0. separation(part): changes by no more than length from 0 to 1. Each step is as long as the
/// separation is above the deepest, or one stride, so that nothing that lasts for a stride is missed. Source: B.
/// Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, 2.3.
template <class Separation>
[[nodiscard]] double part_above(double deepest, double start, const Separation& separation, double length,
                                double stride, double most) {
  stride = std::max(stride, length / limits::kMostSteps);
  double free = 0, now = start;
  while (free < most) {
    double at = std::min(most, free + std::max(now - deepest, stride) / length);
    now = separation(at);
    if (now >= deepest) {
      free = at;
      continue;
    }
    for (int k = 0; k < limits::kHalvings; ++k) {
      const double middle = (free + at) / 2;
      (separation(middle) < deepest ? at : free) = middle;
    }
    return free;
  }
  return most;
}

}  // namespace snug::physics
