// Counts how often rounded arithmetic could not decide. Predicates lie below the algorithms, so no observer is passed
// to them.
#pragma once

#include <cstdint>

namespace snug {

/// Comparisons that this thread has decided exactly so far, because doubles left them open: on which side of a line, a
/// plane, a slab or a sphere a point lies, and whether a swept volume contains it. The difference of two readings is
/// what was spent between them. It is counted where exact arithmetic begins, which takes hundreds of times as long.
inline constinit thread_local std::int64_t exact_decisions = 0;

}  // namespace snug
