// The entries of a covariance matrix as bars, beside the points.
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// Draws the sums while products are added, and the matrix once it is known: to the right of the middle what is
/// positive, to the left what is negative. Returns the room that it takes; empty where the step has neither, or where
/// there is no room.
[[nodiscard]] Rect draw_matrix_inset(Brush& brush, ImVec2 at);
/// See SubjectView::room_of_inset. In space the entries are twice as many, and would stand over most of a phone's
/// picture.
[[nodiscard]] float matrix_room(const Look& look, const lesson::Session& session, const Rect& stage);

}  // namespace snug::app
