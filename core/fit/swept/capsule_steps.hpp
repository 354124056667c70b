// The steps of the capsule's fitter.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "fit/sphere/sphere_steps.hpp"
#include "geometry/capsule.hpp"

namespace snug::fit {

/// The line along the axis around which the points lie closest: through the centre of the smallest circle (in the
/// plane: interval) of the points as seen along it. support: that of the circle; radius: the circle's, in scene units.
struct LineFound {
  static constexpr std::string_view kName = "line_found";
  std::vector<Index> support;
  double radius = 0;
  static constexpr std::array<std::string_view, 2> kFields{"support", "radius"};
  static auto tie(auto& own) { return std::tie(own.support, own.radius); }
};

/// One end of the segment (0: a, 1: b) was moved from the point that reaches farthest to where a cap just contains them
/// all; point: the one that touches the cap; by: how far, in scene units.
struct EndPulledIn {
  static constexpr std::string_view kName = "end_pulled_in";
  int end = 0;
  Index point = kNoIndex;
  double by = 0;
  static constexpr std::array<std::string_view, 3> kFields{"end", "point", "by"};
  static auto tie(auto& own) { return std::tie(own.end, own.point, own.by); }
};

template <class Scalar, int Dim>
using CapsuleStep = Step<Capsule<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>,
                         AxesFound<Scalar, Dim>, LineFound, EndPulledIn, RadiusChecked, Finished>;

/// What fits capsules.
[[nodiscard]] std::span<const Algorithm> rows_of(const Capsule<double, 3>*);

}  // namespace snug::fit
