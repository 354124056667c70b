// The numbers beside the stage: the step's figures, the comparison of algorithms, and the proof.
#pragma once

#include <vector>

#include "app/subject.hpp"

namespace snug::app {

/// The figures of the algorithm for comparison: its step, radius and excess. Empty if there is none.
[[nodiscard]] std::vector<lesson::Figure> figures_beside(const lesson::Session& session);

/// Draws into the current pane, which scrolls if the content does not fit. Returns the height of the step's own figures
/// and panels, without the comparison and the proof below them.
float draw_inspector(const Look& look, lesson::Session& session, const SubjectView& view, const Rect& rect);

}  // namespace snug::app
