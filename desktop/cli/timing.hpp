// Times things with core/measure and this machine's clock, and describes the machine.
#pragma once

#include <functional>
#include <string>

#include "measure/rows.hpp"
#include "measure/timing.hpp"

namespace snug::desktop {

/// The time of a clock that never goes back, ns.
[[nodiscard]] double native_now();
/// The time that the processor has spent on this thread, ns: what other programs take of it does not count.
[[nodiscard]] double processor_now();
/// The clock that costs are measured with: the processor's.
[[nodiscard]] cost::Clock native_clock();

/// Options for timing with that clock: batches of a millisecond, a thousand times the cost of reading it.
[[nodiscard]] cost::TimingOptions native_timing(int repeats);

/// Times run, with a progress bar if it is long. repeats: at least 1.
[[nodiscard]] cost::Timing time_of(std::function<void()> run, int repeats);

/// The provenance of this program on this machine; the caller adds what was measured.
[[nodiscard]] cost::Provenance native_provenance();

}  // namespace snug::desktop
