// Figures as the stage says them; those of the inspector are the lesson room's own.
#pragma once

#include "lesson/figures.hpp"

namespace snug::app {

using lesson::short_figure;

/// The least of 1, 2 and 5 times a power of ten that is no smaller. value: > 0, finite.
[[nodiscard]] double nice_at_least(double value);

}  // namespace snug::app
