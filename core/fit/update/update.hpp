// What the updates of volumes share. A body turns and moves; its volume follows without being fitted anew.
//
// Which frame? A volume is kept in the body's local frame, where it never changes, and each update makes the world's
// from that and from the whole pose. An update of the last frame's world volume by what has happened since compiles as
// well, and is a trap: a box of a box of a box grows with every frame, and a sphere's and an oriented box's roundings
// add up.
//
// What is promised: the updated volume holds, in exact arithmetic, every point of the body as `placed`
// (geometry/pose.hpp) puts it, with its roundings. Boxes keep that promise because rounding never changes the order of
// two numbers; where that does not suffice a bound is moved out by as much as is proven of rounding, which
// tolerance.hpp has.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <tuple>
#include <vector>

#include "fit/aabb/aabb_steps.hpp"
#include "fit/fit.hpp"
#include "geometry/pose.hpp"

namespace snug::fit {

template <class VolumeType>
struct Updated {
  VolumeType volume;  // in the world
};

/// How much larger an updated volume is than the tightest of its kind around the placed points: 0 where it is that
/// one, infinite where only the tightest has no area or volume. measures: of each.
[[nodiscard]] inline double slack(double updated, double tightest) {
  if (updated <= tightest) return 0;
  return tightest > 0 ? updated / tightest - 1 : std::numeric_limits<double>::infinity();
}

/// How many times the volume of the body's convex hull the updated one has: the yardstick that is the same for every
/// kind of volume. Infinite where the hull has no area or volume. measures: of each.
[[nodiscard]] inline double over_hull(double updated, double hull) {
  return hull > 0 ? updated / hull : std::numeric_limits<double>::infinity();
}

/// How far from what it turns about the body reaches, and with which point.
struct ReachFound {
  static constexpr std::string_view kName = "reach_found";
  Index point = kNoIndex;
  double distance = 0;
  static constexpr std::array<std::string_view, 2> kFields{"point", "distance"};
  static auto tie(auto& own) { return std::tie(own.point, own.distance); }
};

/// The vertex that reaches farthest along an axis of the world (of a k-DOP's, whose place is axis), to the one or the
/// other side, was found by walking uphill from the last frame's. path: the vertices on the way, each higher than that
/// before; looked_at: how many were held against the best, those on plateaus too.
struct ExtremeClimbed {
  static constexpr std::string_view kName = "extreme_climbed";
  int axis = 0;
  bool greatest = false;
  std::vector<Index> path;
  Index looked_at = 0;
  static constexpr std::array<std::string_view, 4> kFields{"axis", "greatest", "path", "looked_at"};
  static auto tie(auto& own) { return std::tie(own.axis, own.greatest, own.path, own.looked_at); }
};

/// The bounds along an axis of the world are summed: of each turned local axis the end that lies farther out.
struct BoundsRotated {
  static constexpr std::string_view kName = "bounds_rotated";
  int axis = 0;
  double min = 0, max = 0;
  static constexpr std::array<std::string_view, 3> kFields{"axis", "min", "max"};
  static auto tie(auto& own) { return std::tie(own.axis, own.min, own.max); }
};

/// The centre is where the pose puts it; widened_by: how much radius or half extents grew at most, for rounding's sake.
struct CenterMoved {
  static constexpr std::string_view kName = "center_moved";
  double widened_by = 0;
  static constexpr std::array<std::string_view, 1> kFields{"widened_by"};
  static auto tie(auto& own) { return std::tie(own.widened_by); }
};

/// The axes were turned and made unit and perpendicular again; by: how far the farthest of them is now from its turned
/// self, as a length of the unit vector.
struct AxesTurned {
  static constexpr std::string_view kName = "axes_turned";
  double by = 0;
  static constexpr std::array<std::string_view, 1> kFields{"by"};
  static auto tie(auto& own) { return std::tie(own.by); }
};

template <class VolumeType>
using UpdateStep =
    Step<VolumeType, ReachFound, BoxWidened, ExtremeClimbed, BoundsRotated, CenterMoved, AxesTurned, Finished>;

}  // namespace snug::fit
