// The numbers behind the lines of a sphere's certificate.
#pragma once

#include <string_view>
#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// Adds, for a finished run: how far each point of the support set is from the boundary, the weights by which the
/// centre is a mean of the support set, the lower bound on the radius that follows from them, and, of a careful
/// method, how far its radius was widened. Nothing for other volumes.
void add_certificate(std::vector<Figure>& figures, const FitRun& run, bool naive, const NamesOfPoints& names);

/// The weights of a support set's points, in its order; none if the points are affinely dependent.
[[nodiscard]] std::vector<double> weights_of(const AnyPointSet& points, const std::vector<Index>& support);

/// Whether it is one of a single point of the support set: "off_1", "weight_1".
[[nodiscard]] bool is_of_support(std::string_view key);

}  // namespace snug::lesson
