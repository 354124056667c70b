// The steps of the lozenge's fitter.
#pragma once

#include <string_view>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "fit/sphere/sphere_steps.hpp"
#include "geometry/lozenge.hpp"

namespace snug::fit {

/// The radius: half of how thick the points are along the axis where they are least so, held by the points least and
/// greatest; in the plane what rounds the corners as far as the points allow, held by the point least.
struct ThicknessFound {
  static constexpr std::string_view kName = "thickness_found";
  Index least = kNoIndex, greatest = kNoIndex;
  double radius = 0;
  void fields(auto&& see) const { see("least", least), see("greatest", greatest), see("radius", radius); }
};

/// One side of the rectangle (0, 1: the start and end of its first edge; 2, 3: of its second) was moved from the point
/// that reaches farthest to where what is swept just holds them all; point: the one that then touches; by: how far,
/// scene units.
struct SidePulledIn {
  static constexpr std::string_view kName = "side_pulled_in";
  int side = 0;
  Index point = kNoIndex;
  double by = 0;
  void fields(auto&& see) const { see("side", side), see("point", point), see("by", by); }
};

/// A corner was moved out to a point past both of its sides, the cheaper way: along one edge, the other, or both alike.
/// corner: bit 0 is set at the end of the first edge, bit 1 at that of the second.
struct CornerMovedOut {
  static constexpr std::string_view kName = "corner_moved_out";
  int corner = 0;
  Index point = kNoIndex;
  double along_first = 0, along_second = 0;  // scene units
  void fields(auto&& see) const {
    see("corner", corner), see("point", point), see("along_first", along_first), see("along_second", along_second);
  }
};

template <class Scalar, int Dim>
using LozengeStep = Step<Lozenge<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>,
                         AxesFound<Scalar, Dim>, ThicknessFound, SidePulledIn, CornerMovedOut, RadiusChecked, Finished>;

}  // namespace snug::fit
