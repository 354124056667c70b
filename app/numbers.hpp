// Round numbers for the stage's scales.
#pragma once

namespace snug::app {

/// The least of 1, 2 and 5 times a power of ten that is no smaller. value: > 0, finite.
[[nodiscard]] double nice_at_least(double value);

}  // namespace snug::app
