// What the card of a question has beyond it in an exercise.
#pragma once

#include <string>
#include <utility>

#include "desktop/card_parts.hpp"

namespace snug::desktop {

/// "Decision 3 of 9", "mark 1.5".
[[nodiscard]] std::pair<std::string, std::string> decision_place(const lesson::Sitting& sitting,
                                                                 const lesson::Session& session);
/// What became of the decision before, if it was right: it is told beside the next one.
void draw_before(Column& column, const lesson::Sitting& sitting, const lesson::Session& session);
/// The wrong rule that a first wrong answer follows, and the hints that were taken.
void draw_hints(Column& column, const lesson::Sitting& sitting, const lesson::Session& session);
/// The wrong rule that the answer follows.
void draw_rule(Column& column, const lesson::Sitting& sitting, const lesson::Session& session);
/// The card at an exercise's end, and of one that is built. Both return the command of what was clicked; the caller
/// does it after drawing the card.
[[nodiscard]] std::string draw_mark(Shell& shell, Column& column, const lesson::Sitting& sitting);
[[nodiscard]] std::string draw_build(Shell& shell, Column& column, const lesson::Sitting& sitting);
/// And of the right run, while that is looked at.
[[nodiscard]] std::string draw_right_run(Column& column, const lesson::Sitting& sitting,
                                         const lesson::Session& session);
/// "0.5, 1 hint"; where one practises, without the mark.
[[nodiscard]] std::string mark_words(const lesson::Marked& marked, bool practises);

}  // namespace snug::desktop
