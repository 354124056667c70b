// What can be asked of a chart of costs: no step, so that every question stands before the measurement.
#pragma once

#include "lesson/ask.hpp"

namespace snug::lesson {

/// The choices are the lesson's methods; of the front any number of them.
const char* offer_methods(Asked& asked, const Run& run);
const char* offer_front(Asked& asked, const Run& run);
/// How many times as long the slowest takes as the fastest: decades.
const char* offer_times(Asked& asked, const Run& run);
/// No front is decided by a row that was measured badly: it stays pending.
Truth front_truth(const Asked& asked, const Run& run);
Truth slowest_truth(const Asked& asked, const Run& run);
Truth times_truth(const Asked& asked, const Run& run);
Truth measured_choice_truth(const Asked& asked, const Run& run);

}  // namespace snug::lesson
