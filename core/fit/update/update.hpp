// What the updates of volumes share. A body rotates and moves, and its volume follows without being fitted again.
//
// A volume is kept in the body's local frame, where it never changes. Each update computes the volume in the world
// frame from that and from the whole pose. To update the last frame's world volume by the motion since then would
// compile as well, but is a pitfall: an AABB of an AABB of an AABB grows with every frame, and the rounding errors of a
// sphere or an oriented box add up.
//
// The updated volume contains, in exact arithmetic, every point of the body where `placed`
// (geometry/pose.hpp) puts it, rounding included. For boxes that holds because rounding never changes the
// order of two numbers. Where that is not enough, a bound is moved out by a proven error bound
// (tolerance.hpp).
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "fit/aabb/aabb_steps.hpp"
#include "fit/fit.hpp"
#include "geometry/pose.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

template <class VolumeType>
struct Updated {
  VolumeType volume;  // in the world
};

/// How much larger an updated volume is than the tightest of its kind around the placed points: 0 if it is the
/// tightest; infinite if only the tightest is flat. The arguments are the measures of both.
[[nodiscard]] inline double slack(double updated, double tightest) {
  if (updated <= tightest) return 0;
  return tightest > 0 ? updated / tightest - 1 : std::numeric_limits<double>::infinity();
}

/// The updated volume's measure divided by that of the body's convex hull: the same yardstick for every kind of volume.
/// Infinite if the hull is flat. The arguments are the measures of both.
[[nodiscard]] inline double over_hull(double updated, double hull) {
  return hull > 0 ? updated / hull : std::numeric_limits<double>::infinity();
}

/// How far the body reaches from the pivot that it rotates about, and with which point.
struct ReachFound {
  static constexpr std::string_view kName = "reach_found";
  Index point = kNoIndex;
  double distance = 0;
  SNUG_FIELDS(point, distance);
};

/// At a vertex of a climb, those of its neighbours were examined that had not been seen before. best: the vertex that
/// reached farthest after that, where the climb goes on; if it is the vertex itself, no neighbour reaches farther.
/// axis, greatest: as of ExtremeClimbed.
struct NeighborsCompared {
  static constexpr std::string_view kName = "neighbors_compared";
  int axis = 0;
  bool greatest = false;
  Index vertex = kNoIndex;
  std::vector<Index> neighbors;
  Index best = kNoIndex;
  SNUG_FIELDS(axis, greatest, vertex, neighbors, best);
};

/// The vertex that reaches farthest along a world axis (or an axis of a k-DOP, by its index), to one side or the other,
/// was found by climbing from the last frame's vertex. path: the vertices on the way, each higher than the one before;
/// looked_at: how many vertices were examined, including those on plateaus.
struct ExtremeClimbed {
  static constexpr std::string_view kName = "extreme_climbed";
  int axis = 0;
  bool greatest = false;
  std::vector<Index> path;
  Index looked_at = 0;
  SNUG_FIELDS(axis, greatest, path, looked_at);
};

/// The bounds along a world axis were summed, from the farther end of each rotated local axis.
struct BoundsRotated {
  static constexpr std::string_view kName = "bounds_rotated";
  int axis = 0;
  double min = 0, max = 0;
  SNUG_FIELDS(axis, min, max);
};

/// The centre was moved with the pose; widened_by: how much radius or half extents grew at most, for rounding.
struct CenterMoved {
  static constexpr std::string_view kName = "center_moved";
  double widened_by = 0;
  SNUG_FIELDS(widened_by);
};

/// The axes were rotated, and then made unit and perpendicular again; by: the greatest distance of an axis, as a unit
/// vector, from its rotated self.
struct AxesTurned {
  static constexpr std::string_view kName = "axes_turned";
  double by = 0;
  SNUG_FIELDS(by);
};

template <class VolumeType>
using UpdateStep = Step<VolumeType, ReachFound, BoxWidened, NeighborsCompared, ExtremeClimbed, BoundsRotated,
                        CenterMoved, AxesTurned, Finished>;

}  // namespace snug::fit
