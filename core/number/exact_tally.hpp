// Counts how often rounded arithmetic could not decide: no observer sees it, for predicates are below all algorithms.
#pragma once

#include <cstdint>

namespace snug {

/// Comparisons that this thread has decided exactly so far, because doubles left them open: on which side of a
/// line, a plane, a slab or a sphere a point lies, and whether a swept volume contains it. Two readings differ by what
/// was spent between them. Counted where the exact arithmetic begins, which takes hundreds of times as long.
inline constinit thread_local std::int64_t exact_decisions = 0;

}  // namespace snug
