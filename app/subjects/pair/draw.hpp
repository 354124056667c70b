// What a step of a test of two volumes draws; for this folder only.
#pragma once

#include "app/brush.hpp"
#include "app/subjects/pair/seen_from.hpp"
#include "lesson/held_volume.hpp"

namespace snug::app {

/// seen: the coordinate system; in A's frame A stands still and has no knobs.
void draw_pair(Brush& brush, PairShown shown, const SeenFrom& seen, bool in_frame);

/// Draws both projections onto the axis: each centre with its projected radius to either side, solid towards the other
/// box; and the distance between the centres, so that students see whether it is greater than the sum of the radii.
void draw_projections(Brush& brush, const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis);

/// What a view of the pair has to show: both boxes, the axis beside them with its bars and words, and the arrow of one
/// that is asked about. pair, shown: as they are seen.
[[nodiscard]] Outline outline_of(const lesson::BoxPair& pair, const PairShown& shown, const Camera& camera);
/// The coordinates along the axis where its arrow begins and ends, beyond both projections.
[[nodiscard]] std::array<double, 2> ends_of(const query::AxisTested<double, 3>& axis);
/// Draws a bar with a stroke across each end. aside: unit, across the bar.
void draw_bar(const Brush& brush, ImVec2 from, ImVec2 to, ImVec2 aside, Color color, float width);
/// Draws both projections in a panel at the top of the stage; the room that it takes.
[[nodiscard]] Rect draw_ruler(Brush& brush, const query::AxisTested<double, 3>& axis, ImVec2 at);
[[nodiscard]] float ruler_height(const Look& look);
/// The ends of the arrow of an axis that is asked about.
[[nodiscard]] std::array<Point3, 2> asked_arrow(const lesson::BoxPair& pair, const query::AxisTested<double, 3>& axis);

/// The projections of two volumes onto a direction. ends: least and greatest, scene units along it; farthest: the
/// points there. reach: points that the axis is drawn clear of, a point of A first. tested: whether the test has
/// reached that axis; if not, both intervals are faint, and nothing is said of them.
struct Intervals {
  Point3 direction;  // unit
  std::array<std::array<double, 2>, 2> ends;
  std::array<std::array<Point3, 2>, 2> farthest;
  std::vector<Point3> reach;
  bool separates = false;
  std::string name;
  bool tested = true;
};
void draw_intervals(Brush& brush, const Intervals& both);

/// The coordinate axes that a test of two AABBs has not reached after these steps. None while a question is open whose
/// answer can be read from the intervals along them.
[[nodiscard]] std::vector<int> untested_axes(const lesson::Session& session, lesson::PairSteps steps);
/// Draws both intervals along these axes, faintly.
void draw_untested(Brush& brush, lesson::PairSteps steps);

/// Draws two volumes of any kind, and what the last of the steps is about.
void draw_volumes(Brush& brush, lesson::PairSteps steps);

/// Draws the difference A - B of both cores in the plane, the origin and the simplex, in a corner of the stage below a
/// height. Returns the room that it takes; empty if there is not enough.
[[nodiscard]] Rect draw_difference(Brush& brush, lesson::PairSteps steps, ImVec2 at);
/// How high it is on a stage that is high enough for it.
[[nodiscard]] float difference_height(const Look& look, const Rect& stage);

/// A rectangle around a place, across an axis, so many units to each side.
[[nodiscard]] std::array<Point3, 4> plane_across(const Point3& axis, const Point3& middle, double half);

}  // namespace snug::app
