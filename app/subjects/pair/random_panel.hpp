// Which axis separates random pairs of boxes how often.
#pragma once

#include <optional>

#include "app/look.hpp"
#include "app/panel_words.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws a row for each axis: at how many of the pairs the test ends there, and how many it separates at all. Returns
/// its height; 0 if the lesson counts none.
float draw_random_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);
/// The same in words; none if the lesson counts none.
[[nodiscard]] std::optional<PanelWords> random_in_words(const lesson::Session& session);

}  // namespace snug::app
