// Which axis separates random pairs of boxes how often.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws a row for each axis: at how many of the pairs the test ends there, and how many it separates at all. Returns
/// its height; 0 if the lesson counts none.
float draw_random_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
