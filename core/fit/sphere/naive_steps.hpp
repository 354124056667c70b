// The steps of the sphere fitters that are as textbooks print them.
#pragma once

#include "fit/sphere/sphere_steps.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The textbook's formula for the sphere through these points has no finite result in rounded arithmetic: the
/// determinant that it divides by is 0, or too small. The last of them is passed over.
struct CircumsphereFailed {
  static constexpr std::string_view kName = "circumsphere_failed";
  Support points;
  SNUG_FIELDS(points);
};

/// The algorithm has made as many tests as it may, and was stopped with the ball as it stood.
struct TestsExhausted {
  static constexpr std::string_view kName = "tests_exhausted";
  Index tests = 0;
  SNUG_FIELDS(tests);
};

template <class Scalar, int Dim>
using NaiveSphereStep = Step<Sphere<Scalar, Dim>, PointExamined, BoundaryForced, MovedToFront, CircumsphereFailed,
                             TestsExhausted, Finished>;

}  // namespace snug::fit
