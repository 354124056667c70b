// How rare the false positives of a sphere's test are, measured on request.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws a button that starts the survey, its progress and its counts, and works on it for a part of a frame. working:
/// whether it goes on. Returns the height; 0 where no sphere is tested.
float draw_survey_panel(const Look& look, lesson::Session& session, ImVec2 at, float width, bool& working);

}  // namespace snug::app
