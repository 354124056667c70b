// What a step of a test of two boxes shows.
#pragma once

#include "app/shown.hpp"
#include "lesson/subjects/pair/pair.hpp"

namespace snug::app {

struct PairShown : Shown {
  /// The axis that the step is about (lesson::axis_at), and the one that a question asks about.
  std::optional<query::AxisTested<double, 3>> axis, axis_asked;
  std::optional<query::OutlinesCompared> outlines;  // for the wrong tests
  std::optional<query::CornerTried> corner;
};

[[nodiscard]] PairShown pair_shown_at(const lesson::Session& session);

/// Shows a row of the table instead of the step's axis: with both projections if it was tested, and otherwise its
/// direction alone.
void show_row(PairShown& shown, const lesson::Session& session, int row);

/// The steps up to and including the current one; none before the first.
[[nodiscard]] lesson::PairSteps steps_shown(const lesson::Session& session);

}  // namespace snug::app
