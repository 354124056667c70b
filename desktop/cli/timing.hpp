// How long something takes, by a clock that only goes forward.
#pragma once

#include <functional>

namespace snug::desktop {

struct Timing {
  double median = 0;  // nanoseconds of one run
  double min = 0;
  int repeats = 0;
};

/// Takes the time of run so many times over; short ones in batches that are long enough for the clock.
/// repeats: at least 1.
[[nodiscard]] Timing time_of(const std::function<void()>& run, int repeats);

}  // namespace snug::desktop
