// What the proof of a result says, from the returned numbers and the points alone. Tests use it as their oracle, and a
// panel shows it. Each volume's proof stands in its folder: certify_sphere.hpp, certify_obb.hpp and so on.
#pragma once

#include <optional>

#include "fit/fit.hpp"

namespace snug::fit {

struct Certificate {
  bool contains = false;        // every point, in exact arithmetic
  Index outside = 0;            // how many points it does not contain
  double max_outside = 0;       // the farthest that any point lies outside, scene units; 0 if all are inside
  bool on_boundary = false;     // every support point, within rounding
  double lower_bound = 0;       // no smaller ball contains even the support set; scene units
  double excess = 0;            // radius / lower_bound - 1 where the bound is positive; 0 for a ball of radius 0
  std::optional<bool> optimal;  // whether radius and bound agree within rounding; none if optimality is not claimed
};

}  // namespace snug::fit
