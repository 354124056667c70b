// The recursion that lectures print, which takes one point off the set in each call: run only to see how deep it goes.
// The catalogue's Welzl needs no stack (fit/sphere/welzl.hpp).
#pragma once

#include "geometry/point_set.hpp"

namespace snug::cost {

struct RecursionDepth {
  Index deepest = 0;          // calls within calls
  double bytes_per_call = 0;  // of the stack, as this build has it
};

/// Source: E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991. points: a few thousand at most, for the
/// stack's sake.
[[nodiscard]] RecursionDepth naive_welzl_depth(PointSpan<double, 3> points);

}  // namespace snug::cost
