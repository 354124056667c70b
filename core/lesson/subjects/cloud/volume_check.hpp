// Tests a step's volume against the points, whatever scalar they have.
#pragma once

#include "fit/catalogue.hpp"

namespace snug::lesson {

/// How many points lie outside by more than rounding: a ball that has just grown to a point may miss it by an ulp. A
/// point that is seen outside counts, wherever the points lie.
[[nodiscard]] Index count_outside(const AnyPointSet& points, const fit::Volume3& volume);

/// What is true of a ball at a step, and of its support set.
struct StepCertificate {
  bool on_boundary = false;  // every support point, within rounding
  bool smallest = false;     // whether no smaller ball contains the support, within rounding
};
[[nodiscard]] StepCertificate certify_step(const AnyPointSet& points, const fit::Sphere3& ball,
                                           const std::vector<Index>& support);

}  // namespace snug::lesson
