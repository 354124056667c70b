#include "lesson/subjects/cloud/certificate_lines.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/figures.hpp"
#include "lesson/subjects/cloud/certificate_figures.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"
#include "number/double_double.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostContained = 6;

/// |p − c|² − r²
Dyadic excess_at(const Point3& p, const fit::Sphere3& sphere) {
  Dyadic excess = -(Dyadic(sphere.radius) * Dyadic(sphere.radius));
  for (int axis = 0; axis < 3; ++axis) {
    const Dyadic apart = Dyadic(p[axis]) - Dyadic(sphere.center[axis]);
    excess += apart * apart;
  }
  return excess;
}

/// Compares all points in twice a double's digits, and only the farthest of them exactly.
void add_contained(CertificateLines& lines, const AnyPointSet& points, const fit::Sphere3& sphere) {
  std::vector<std::pair<double, Index>> all;
  for (Index i = 0; i < fit::count_of(points); ++i) all.emplace_back(-outside_by(fit::point_of(points, i), sphere), i);
  std::sort(all.begin(), all.end());
  for (const auto& [inside, i] : all) {
    if (lines.contained.size() < kMostContained) {
      lines.contained.push_back({i, exact_number(excess_at(fit::point_of(points, i), sphere))});
      continue;
    }
    ++lines.others;
    lines.others_outside += inside < 0 ? 1 : 0;
  }
}

void add_mean(CertificateLines& lines, const FitRun& run, const fit::Sphere3& sphere) {
  Dyadic sum(-1);
  std::vector<Dyadic> mean;
  for (int axis = 0; axis < run.dim(); ++axis) mean.emplace_back(-sphere.center[axis]);
  for (const CertificateLines::Support& own : lines.support) {
    if (!own.weight) return;
    const Point3 point = fit::point_of(run.points(), own.point);
    sum += Dyadic(*own.weight);
    for (int axis = 0; axis < run.dim(); ++axis) mean[axis] += Dyadic(*own.weight) * Dyadic(point[axis]);
  }
  lines.sum_off = exact_number(sum);
  for (const Dyadic& off : mean) lines.mean_off.push_back(exact_number(off));
}

/// The distance of the farthest point, rounded to the nearest double.
double farthest_distance(const AnyPointSet& points, const Point3& center) {
  DoubleDouble most;
  for (Index i = 0; i < fit::count_of(points); ++i) {
    DoubleDouble square;
    for (int axis = 0; axis < 3; ++axis) {
      const DoubleDouble apart = DoubleDouble::sum(fit::point_of(points, i)[axis], -center[axis]);
      square += apart * apart;
    }
    if (most < square) most = square;
  }
  const double root = std::sqrt(most.value());
  if (!(root > 0)) return 0;
  return root + (most - DoubleDouble::product(root, root)).value() / (2 * root);
}

}  // namespace

ExactNumber exact_number(const Dyadic& value) {
  auto [digits, exponent] = value.odd_times_power();
  const bool negative = digits.starts_with('-');
  if (negative) digits.erase(0, 1);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return {(negative ? "−" : "") + digits, exponent != 0 ? " × 2" + raised(exponent) : "", value.sign()};
}

std::optional<CertificateLines> certificate_lines(const FitRun& run, const AnyPointSet* given) {
  const fit::Result& result = run.recording().result;
  const auto* sphere = std::get_if<fit::Sphere3>(&result.volume);
  if (sphere == nullptr) return std::nullopt;
  CertificateLines lines;
  add_contained(lines, run.points(), *sphere);
  const double ulp = ulp_of(run.points(), sphere->radius);
  const std::vector<double> weights = weights_of(run.points(), result.support);
  for (std::size_t i = 0; i < result.support.size(); ++i) {
    const Index point = result.support[i];
    lines.support.push_back({point, outside_by(fit::point_of(run.points(), point), *sphere) / ulp,
                             i < weights.size() ? std::optional(weights[i]) : std::nullopt});
  }
  add_mean(lines, run, *sphere);
  if (given != nullptr && fit::are_float(run.points()))
    lines.rounded = fit::rounded(result, run.recording().certificate, run.points(), all_points(*given));
  return lines;
}

std::string rounded_text(const fit::Rounded& rounded) {
  if (rounded.by == 0) return "All of this is about the points in float: rounding moved none of them.";
  const std::string moved = "All of this is about the points as rounded to float, which moved them by " +
                            number_text(rounded.by) + " units at most. Before that, ";
  return moved + (rounded.max_outside == 0
                      ? "they were all inside as well."
                      : "the farthest lay " + number_text(rounded.max_outside) + " units outside.");
}

double widened_ulps(const AnyPointSet& points, const fit::Sphere3& sphere) {
  double nearest = farthest_distance(points, sphere.center);
  if (fit::are_float(points)) nearest = static_cast<float>(nearest);
  return (sphere.radius - nearest) / ulp_of(points, sphere.radius);
}

}  // namespace snug::lesson
