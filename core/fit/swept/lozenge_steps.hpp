// The steps of the lozenge's fitter.
#pragma once

#include <span>
#include <string_view>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "fit/sphere/sphere_steps.hpp"
#include "geometry/lozenge.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The radius. In space, half of the points' extent along the axis along which they are thinnest; the points least and
/// greatest support it. In the plane, the radius that rounds the corners as far as the points allow; the point least
/// supports it.
struct ThicknessFound {
  static constexpr std::string_view kName = "thickness_found";
  Index least = kNoIndex, greatest = kNoIndex;
  double radius = 0;
  SNUG_FIELDS(least, greatest, radius);
};

/// One side of the rectangle (0, 1: at the start and end of its first edge; 2, 3: of its second) was pulled in from
/// beside the point that reaches farthest, until the lozenge just contains all points. point: the one that then touches
/// it; by: how far, scene units.
struct SidePulledIn {
  static constexpr std::string_view kName = "side_pulled_in";
  int side = 0;
  Index point = kNoIndex;
  double by = 0;
  SNUG_FIELDS(side, point, by);
};

/// A vertex was moved out to a point past both of its sides, in the cheapest way: along one edge, the other, or both
/// alike. corner: bit 0 is set at the end of the first edge, bit 1 at the end of the second.
struct CornerMovedOut {
  static constexpr std::string_view kName = "corner_moved_out";
  int corner = 0;
  Index point = kNoIndex;
  double along_first = 0, along_second = 0;  // scene units
  SNUG_FIELDS(corner, point, along_first, along_second);
};

template <class Scalar, int Dim>
using LozengeStep = Step<Lozenge<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>,
                         AxesFound<Scalar, Dim>, ThicknessFound, SidePulledIn, CornerMovedOut, RadiusChecked, Finished>;

/// What fits lozenges.
[[nodiscard]] std::span<const Algorithm> rows_of(const Lozenge<double, 3>*);

}  // namespace snug::fit
