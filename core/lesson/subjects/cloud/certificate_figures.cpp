#include "lesson/subjects/cloud/certificate_figures.hpp"

#include <algorithm>
#include <cmath>

#include "fit/sphere/support_ball.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"

namespace snug::lesson {
namespace {

/// The weights of a support set's points, in its order; none if the points are affinely dependent.
std::vector<double> weights_of(const AnyPointSet& points, const std::vector<Index>& support) {
  fit::Support own;
  for (const Index i : support) own.add(i);
  const auto weights = [&](const auto& set) {
    const auto ball = fit::ball_through(set.span(), own);
    return ball ? std::vector<double>(ball->weights.begin(), ball->weights.begin() + own.size())
                : std::vector<double>();
  };
  return std::visit(weights, points);
}

/// The farthest that a point of the support set lies from the boundary, on either side; scene units.
double off_boundary(const FitRun& run, const fit::Sphere3& sphere) {
  double most = 0;
  for (const Index i : run.recording().result.support)
    most = std::max(most, std::abs(outside_by(fit::point_of(run.points(), i), sphere)));
  return most;
}

}  // namespace

void add_certificate(std::vector<Figure>& figures, const FitRun& run, const NamesOfPoints& names) {
  const auto* sphere = std::get_if<fit::Sphere3>(&run.recording().result.volume);
  if (sphere == nullptr) return;
  const double ulp = left_outside(run.points(), *sphere).radius_ulp, bound = run.recording().certificate.lower_bound;
  const auto add_ulps = [&](std::string name, std::string key, double length) {
    if (const double ulps = length / ulp; std::isfinite(ulps))
      figures.push_back({std::move(name), std::move(key), ulps_text(ulps), ulps, "ulps"});
  };
  add_ulps("Off the boundary", "boundary_ulps", off_boundary(run, *sphere));
  const std::vector<Index>& support = run.recording().result.support;
  const std::vector<double> weights = weights_of(run.points(), support);
  for (std::size_t i = 0; i < weights.size(); ++i)
    figures.push_back({"Weight of " + point_name(support[i], names), "weight_" + std::to_string(i + 1),
                       number_text(weights[i]), weights[i], ""});
  if (!weights.empty()) {
    const double least = *std::min_element(weights.begin(), weights.end());
    figures.push_back({"Least weight", "least_weight", number_text(least), least, ""});
  }
  figures.push_back({"Lower bound", "lower_bound", number_text(bound) + " units", bound, "units"});
  add_ulps("Radius above it", "bound_ulps", sphere->radius - bound);
}

}  // namespace snug::lesson
