// 14-DOPs beside the smallest oriented boxes around many random clouds, as a chart beside the stage.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws it if a k-DOP in space is shown in a lesson that compares both. Returns its height; 0 if there is none.
float draw_census_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
