#include "lesson/subjects/cloud/certificate_figures.hpp"

#include <algorithm>
#include <cmath>

#include "fit/sphere/support_ball.hpp"
#include "lesson/subjects/cloud/certificate_lines.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"

namespace snug::lesson {

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

bool is_of_support(std::string_view key) { return key.starts_with("off_") || key.starts_with("weight_"); }

void add_certificate(std::vector<Figure>& figures, const FitRun& run, bool naive, const NamesOfPoints& names) {
  const auto* sphere = std::get_if<fit::Sphere3>(&run.recording().result.volume);
  if (sphere == nullptr) return;
  const double ulp = ulp_of(run.points(), sphere->radius), bound = run.recording().certificate.lower_bound;
  const auto add_ulps = [&](std::string name, std::string key, double ulps, bool with_sign = false) {
    if (std::isfinite(ulps))
      figures.push_back(
          {std::move(name), std::move(key), (with_sign && ulps > 0 ? "+" : "") + ulps_text(ulps), ulps, "ulps"});
  };
  const std::vector<Index>& support = run.recording().result.support;
  const auto off = [&](Index i) { return outside_by(fit::point_of(run.points(), i), *sphere) / ulp; };
  double most = 0;
  for (const Index i : support) most = std::max(most, std::abs(off(i)));
  add_ulps("Off the boundary", "boundary_ulps", most);
  for (std::size_t i = 0; i < support.size(); ++i)
    add_ulps(point_name(support[i], names) + " off the boundary", "off_" + std::to_string(i + 1), off(support[i]),
             true);
  const std::vector<double> weights = weights_of(run.points(), support);
  for (std::size_t i = 0; i < weights.size(); ++i)
    figures.push_back({"Weight of " + point_name(support[i], names), "weight_" + std::to_string(i + 1),
                       number_text(weights[i]), weights[i], ""});
  if (!weights.empty()) {
    const double least = *std::min_element(weights.begin(), weights.end());
    figures.push_back({"Least weight", "least_weight", number_text(least), least, ""});
  }
  figures.push_back({"Lower bound", "lower_bound", number_text(bound) + " units", bound, "units"});
  add_ulps("Radius above it", "bound_ulps", (sphere->radius - bound) / ulp);
  if (!naive) add_ulps("Radius widened by", "widened_ulps", widened_ulps(run.points(), *sphere));
}

}  // namespace snug::lesson
