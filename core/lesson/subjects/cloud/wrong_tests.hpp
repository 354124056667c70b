// Where a naive algorithm breaks: the rounded tests of its run that say the opposite of exact arithmetic.
#pragma once

#include <vector>

#include "fit/catalogue.hpp"
#include "geometry/vector.hpp"

namespace snug::lesson {

/// A test whether a point is outside: of the exact sphere through the support set so far, or, for a hull in the plane,
/// of the two edges that it is shared between.
struct WrongTest {
  int step = 0;  // counted from 0
  Index point = kNoIndex;
  enum class Truth { kInside, kOnBoundary, kOutside, kNotOutside } truth = Truth::kInside;  // the test said otherwise
};

/// Those of a run, in order. points: those of the run.
[[nodiscard]] std::vector<WrongTest> wrong_tests(const fit::Recording& recording, const AnyPointSet& points);

}  // namespace snug::lesson
