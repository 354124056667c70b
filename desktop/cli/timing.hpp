// How long something takes here: core/measure with this machine's clock, and what is to be known of the machine.
#pragma once

#include <functional>
#include <string>

#include "measure/rows.hpp"
#include "measure/timing.hpp"

namespace snug::desktop {

/// One that only goes forward, ns.
[[nodiscard]] double native_now();
[[nodiscard]] cost::Clock native_clock();

/// How times are taken by that clock: batches of a millisecond, ten thousand times what reading it costs.
[[nodiscard]] cost::TimingOptions native_timing(int repeats);

/// Takes the time of run, with a progress bar where it is long. repeats: at least 1.
[[nodiscard]] cost::Timing time_of(std::function<void()> run, int repeats);

/// The provenance of this program on this machine; the caller adds what was measured.
[[nodiscard]] cost::Provenance native_provenance();

}  // namespace snug::desktop
