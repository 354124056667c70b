// A volume of a step held against the points, whatever they were computed in.
#pragma once

#include "fit/catalogue.hpp"

namespace snug::lesson {

/// How many points lie outside by more than rounding: a step's ball that grew to a point may miss it by an ulp.
[[nodiscard]] Index count_outside(const AnyPointSet& points, const fit::Volume3& volume);

/// What holds of a ball on the way and the points that hold it.
struct StepCertificate {
  bool on_boundary = false;  // every support point, within rounding
  bool smallest = false;     // no smaller ball holds the support, within rounding
};
[[nodiscard]] StepCertificate certify_step(const AnyPointSet& points, const fit::Sphere3& ball,
                                           const std::vector<Index>& support);

}  // namespace snug::lesson
