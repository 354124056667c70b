// What stands on a stage beside what the stage is about (lesson/beside.hpp).
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// Whether something stands there. It goes with the first change of what the stage is about.
[[nodiscard]] bool has_beside(const lesson::Session& session);
/// The ball around what a view shows and what stands beside it, as far as that is near enough.
[[nodiscard]] fit::Sphere3 ball_with_beside(const lesson::Session& session, const fit::Sphere3& shown);
/// Draws each with a line of its own kind, or a mark where it is a point, and its name.
void draw_beside(Brush& brush);

}  // namespace snug::app
