// What a step of a test of a box against a frustum draws; for this folder only.
#pragma once

#include "app/point_marks.hpp"
#include "app/subjects/frustum/shown.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::app {

/// The frustum's vertices and faces, in the order of a box's.
[[nodiscard]] Polytope solid_of(const lesson::BoxPair& pair);
/// Draws the body: a box, a ball with the frustum's planes moved out by its radius, or a point.
void draw_body(Brush& brush, const lesson::BoxPair& pair, Color color);
/// Draws the distance of a ball's or a point's centre from the plane, and the ball's radius towards it and away.
void draw_center_distance(Brush& brush, const query::PlaneTested<double, 3>& plane, const Point3& normal,
                          const lesson::BoxPair& pair);

/// The normal of the step's plane: where it is drawn, and its vector.
struct NormalArrow {
  Point3 foot, normal;
};
[[nodiscard]] NormalArrow normal_arrow(const lesson::BoxPair& pair, const FrustumShown& shown);

void draw_frustum(Brush& brush, const FrustumShown& shown);
/// Marks the p- and the n-vertex with their letters.
void mark_frustum(Brush& brush, const FrustumShown& shown);
/// Names them, away from the box.
void name_frustum(PointNames& names, const FrustumShown& shown);
/// See SubjectView::draw_inset.
[[nodiscard]] Rect draw_from_camera(Brush& brush, const FrustumShown& shown, ImVec2 at);

}  // namespace snug::app
