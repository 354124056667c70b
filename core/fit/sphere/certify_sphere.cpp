#include "fit/sphere/certify_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "fit/sphere/support_ball.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {
namespace {

/// A lower bound on the radius of any ball that contains the support: the largest radius of a circumsphere of a subset
/// whose centre lies in the subset's hull.
template <class Scalar, int Dim>
double support_lower_bound(const Support& support, PointSpan<Scalar, Dim> points) {
  double bound = 0;
  for (const Index i : support) bound = std::max(bound, smallest_ball_with(points, i, support).radius);
  return bound;
}

}  // namespace

template <class Scalar, int Dim>
Certificate certify(const Fit<Sphere<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  Certificate certificate;
  const Vector<double, Dim> center = fit.volume.center.template cast<double>();
  const auto radius = static_cast<double>(fit.volume.radius);
  const auto distance = [&](Index i) { return scaled_norm<double, Dim>(points[i].template cast<double>() - center); };

  double largest = center.cwiseAbs().maxCoeff();
  for (Index i = 0; i < points.size(); ++i) {
    largest = std::max(largest, static_cast<double>(points[i].cwiseAbs().maxCoeff()));
    if (side_of_sphere(points[i], fit.volume) <= 0) continue;
    ++certificate.outside;
    // The exact verdict can be decided by less than the distance's own rounding error: report one ulp then.
    const double ulp = std::nextafter(radius, 2 * radius + 1) - radius;
    certificate.max_outside = std::max({certificate.max_outside, distance(i) - radius, ulp});
  }
  certificate.contains = certificate.outside == 0;

  const double roundoff = tolerance::roundoff<Scalar>(radius + largest);
  certificate.on_boundary = std::all_of(fit.support.begin(), fit.support.end(), [&](Index i) {
    return std::abs(distance(i) - radius) <= tolerance::kBoundaryRoundoffs * roundoff;
  });
  certificate.lower_bound = support_lower_bound(fit.support, points);
  if (certificate.lower_bound > 0) certificate.excess = radius / certificate.lower_bound - 1;
  if (claims_optimal)
    certificate.optimal =
        certificate.contains && radius - certificate.lower_bound <= tolerance::kOptimalityRoundoffs * roundoff;
  return certificate;
}

template Certificate certify(const Fit<Sphere<float, 2>>&, PointSpan<float, 2>, bool);
template Certificate certify(const Fit<Sphere<float, 3>>&, PointSpan<float, 3>, bool);
template Certificate certify(const Fit<Sphere<double, 2>>&, PointSpan<double, 2>, bool);
template Certificate certify(const Fit<Sphere<double, 3>>&, PointSpan<double, 3>, bool);

}  // namespace snug::fit
