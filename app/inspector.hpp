// The numbers beside the stage: of the step, of the algorithms beside each other, and of the proof.
#pragma once

#include <vector>

#include "app/subject.hpp"

namespace snug::app {

/// What is said of the algorithm beside the main one: how far it is, its radius and excess. Empty where there is none.
[[nodiscard]] std::vector<lesson::Figure> figures_beside(const lesson::Session& session);

/// Draws into the current pane, which scrolls where it does not fit.
void draw_inspector(const Look& look, lesson::Session& session, const SubjectView& view, const Rect& rect);

}  // namespace snug::app
