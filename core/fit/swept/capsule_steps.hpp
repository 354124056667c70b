// The steps of the capsule's fitter.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "fit/sphere/sphere_steps.hpp"
#include "geometry/capsule.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The line along the axis around which the points lie closest: through the centre of the smallest circle (in the
/// plane: interval) of the points as seen along it. support: that of the circle; radius: the circle's, in scene units.
struct LineFound {
  static constexpr std::string_view kName = "line_found";
  std::vector<Index> support;
  double radius = 0;
  SNUG_FIELDS(support, radius);
};

/// One end of the segment (0: a, 1: b) was moved from the point that reaches farthest to where a cap just contains them
/// all; point: the one that touches the cap; by: how far, in scene units.
struct EndPulledIn {
  static constexpr std::string_view kName = "end_pulled_in";
  int end = 0;
  Index point = kNoIndex;
  double by = 0;
  SNUG_FIELDS(end, point, by);
};

template <class Scalar, int Dim>
using CapsuleStep = Step<Capsule<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>,
                         AxesFound<Scalar, Dim>, LineFound, EndPulledIn, RadiusChecked, Finished>;

/// What fits capsules.
[[nodiscard]] std::span<const Algorithm> rows_of(const Capsule<double, 3>*);

}  // namespace snug::fit
