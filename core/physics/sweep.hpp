// How far along its path a body can go: by conservative advancement.
#pragma once

#include <algorithm>

#include "physics/limits.hpp"

namespace snug::physics {

/// The last part of a way up to which a separation stays at or above the deepest that is allowed, at most so much.
/// start: the separation at part 0. separation(part): changes by no more than length from part 0 to 1. Each look is as
/// far on from the one before as that is above the deepest, or a stride: so what lasts for a stride is not missed.
/// Source: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, 2.3.
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
