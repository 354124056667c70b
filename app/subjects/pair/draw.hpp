// What a step of a test of two boxes draws; for this folder.
#pragma once

#include "app/brush.hpp"
#include "app/subjects/pair/shown.hpp"

namespace snug::app {

void draw_pair(Brush& brush, const PairShown& shown);

/// Both projections on the axis: each centre with its projected radius to either side, solid towards the other box; and
/// the distance of the centres, so that one sees whether it is greater than both radii together.
void draw_projections(Brush& brush, const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis);

/// What two volumes cover of a direction. ends: least and greatest, scene units along it; farthest: the points that lie
/// there. reach: what the axis stands clear of, a point of A first.
struct Intervals {
  Point3 direction;  // unit
  std::array<std::array<double, 2>, 2> ends;
  std::array<std::array<Point3, 2>, 2> farthest;
  std::vector<Point3> reach;
  bool separates = false;
  std::string name;
};
void draw_intervals(Brush& brush, const Intervals& both);

/// Two volumes of any kind, and what the last of the steps speaks of.
void draw_volumes(Brush& brush, lesson::PairSteps steps);

/// The difference A - B of both cores in the plane, the origin and the simplex: in a corner of the stage below a
/// height. Returns the room that it takes; empty where there is none for it.
[[nodiscard]] Rect draw_difference(Brush& brush, lesson::PairSteps steps, float top);

}  // namespace snug::app
