// The table of the 28 pairs of volumes and their tests. A cell puts its pair on the stage.
#pragma once

#include <optional>
#include <string_view>

#include "app/look.hpp"
#include "app/panel_words.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws the table, if students choose the kinds of volumes, and returns its height.
float draw_pair_table(const Look& look, lesson::Session& session, ImVec2 at, float width);
/// The same in words; none where it draws nothing.
[[nodiscard]] std::optional<PanelWords> pairs_in_words(const lesson::Session& session);

inline constexpr std::string_view kMeasurePairs = "measure_pairs";
/// Begins to measure what each pair costs. Returns false where that is impossible now.
bool measure_pairs(lesson::Session& session);
/// Goes on for a part of a frame. Returns whether there is more to measure.
bool work_on_pairs(lesson::Session& session);

}  // namespace snug::app
