// What a finished naive run leaves outside: its marks on the stage, and the worst of it under a magnifier.
#pragma once

#include "app/point_marks.hpp"
#include "app/subjects/cloud/shown.hpp"

namespace snug::app {

void mark_left_outside(Brush& brush, const CloudShown& shown);
void name_left_outside(PointNames& names, const CloudShown& shown);

/// Draws the worst point beside the boundary, with a ruler in ulps. Returns the room that it takes; empty where nothing
/// is outside, where it lies so far out that the stage shows it, or where there is no room.
[[nodiscard]] Rect draw_ulp_inset(Brush& brush, const CloudShown& shown, ImVec2 at);

}  // namespace snug::app
