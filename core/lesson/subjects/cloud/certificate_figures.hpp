// The numbers behind the lines of a sphere's certificate.
#pragma once

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// Adds, for a finished run: how far the support set is off the boundary, the weights by which the centre is a mean of
/// the support set, and the lower bound on the radius that follows from them. Nothing for other volumes.
void add_certificate(std::vector<Figure>& figures, const FitRun& run, const NamesOfPoints& names);

}  // namespace snug::lesson
