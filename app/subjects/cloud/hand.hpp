// How what is set by hand stands on the stage.
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// Whether a handle of the cloud is on the stage: a point, or one of a method by hand that is shown.
[[nodiscard]] bool shows_handle(const lesson::Session& session, Index i);
/// Draws the handles of the methods by hand that are shown, and the cores that they set.
void draw_hand(Brush& brush);
/// Draws a direction and its image under the covariance, where the run is about them.
void draw_image(Brush& brush);
/// The ball, enlarged until it contains those handles.
[[nodiscard]] fit::Sphere3 with_hand(const lesson::Session& session, const fit::Sphere3& ball);

}  // namespace snug::app
