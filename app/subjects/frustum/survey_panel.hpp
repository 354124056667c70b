// How rare the false positives of a sphere's test are, measured on request.
#pragma once

#include <optional>
#include <string_view>

#include "app/look.hpp"
#include "app/panel_words.hpp"
#include "lesson/session.hpp"

namespace snug::app {

inline constexpr std::string_view kSurveyCommand = "survey";

/// Draws a button that starts the survey, its progress and its counts. Returns the height; 0 where no sphere is tested.
float draw_survey_panel(const Look& look, lesson::Session& session, ImVec2 at, float width);
/// The same in words; none where it draws nothing.
[[nodiscard]] std::optional<PanelWords> survey_in_words(const lesson::Session& session);
/// Returns false if there is none to start.
bool start_survey(lesson::Session& session);
/// Goes on with the survey for a part of a frame. Returns whether there is one that is not done.
bool work_on_survey(lesson::Session& session);

}  // namespace snug::app
