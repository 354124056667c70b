// What can be asked about a cost chart. No question is about a step: all are asked before the measurement.
#pragma once

#include "lesson/ask.hpp"

namespace snug::lesson {

/// The choices are the lesson's methods; for the front, any number of them.
const char* offer_methods(Asked& asked, const Run& run);
const char* offer_front(Asked& asked, const Run& run);
/// How many times as long the slowest takes as the fastest; the choices are decades.
const char* offer_times(Asked& asked, const Run& run);
/// The front stays pending while a time of its rows is unreliable.
Truth front_truth(const Asked& asked, const Run& run);
Truth slowest_truth(const Asked& asked, const Run& run);
Truth times_truth(const Asked& asked, const Run& run);
Truth measured_choice_truth(const Asked& asked, const Run& run);

}  // namespace snug::lesson
