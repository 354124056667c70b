// Figures as the stage says them; those of the inspector are the lesson room's own.
#pragma once

#include <string>

namespace snug::app {

/// A length beside another one, as short as it still says something: "0.58", "0.0042", "123.4".
[[nodiscard]] std::string short_figure(double value);

/// The least of 1, 2 and 5 times a power of ten that is no smaller. value: > 0, finite.
[[nodiscard]] double nice_at_least(double value);

}  // namespace snug::app
