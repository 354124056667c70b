// The number of every plane at once: on which side of each the centre of a point or a ball is.
#pragma once

#include <optional>

#include "app/look.hpp"
#include "app/panel_words.hpp"
#include "app/subjects/frustum/shown.hpp"

namespace snug::app {

/// Draws a row for each plane, the one at hand lit. Returns the height; 0 for a box, and while an answer is predicted.
float draw_planes_panel(const Look& look, const lesson::Session& session, const FrustumShown& shown, ImVec2 at,
                        float width);
/// The same in words; none where it draws nothing.
[[nodiscard]] std::optional<PanelWords> planes_in_words(const lesson::Session& session);

}  // namespace snug::app
