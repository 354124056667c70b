// How far calipers have turned around a projection of the points.
#pragma once

#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// The edges on which the calipers have stood after the first `steps` steps of a trace, on the projection that the last
/// of these steps is about. Empty if it is about none, or if its edges were too many to be reported.
[[nodiscard]] std::vector<const fit::CalipersTurned<double, 3>*> calipers_turn(FitTrace trace, int steps);

}  // namespace snug::lesson
