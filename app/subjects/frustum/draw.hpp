// What a step of a test of a box against a frustum draws; for this folder only.
#pragma once

#include "app/point_marks.hpp"
#include "app/subjects/frustum/shown.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::app {

void draw_frustum(Brush& brush, const FrustumShown& shown);
/// Marks the p- and the n-vertex with their letters.
void mark_frustum(Brush& brush, const FrustumShown& shown);
/// Names them, away from the box.
void name_frustum(PointNames& names, const FrustumShown& shown);
/// See SubjectView::draw_inset.
[[nodiscard]] Rect draw_from_camera(Brush& brush, const FrustumShown& shown, float top);

}  // namespace snug::app
