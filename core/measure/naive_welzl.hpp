// The recursion as lectures print it, which removes one point in each call: run only to measure how deep it goes. The
// catalogue's Welzl needs no stack (fit/sphere/welzl.hpp).
#pragma once

#include "geometry/point_set.hpp"

namespace snug::cost {

struct RecursionDepth {
  Index deepest = 0;          // the greatest call depth
  double bytes_per_call = 0;  // of the stack, in this build
};

/// Source: E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991. points: a few thousand at most, or the
/// stack overflows.
[[nodiscard]] RecursionDepth naive_welzl_depth(PointSpan<double, 3> points);

}  // namespace snug::cost
