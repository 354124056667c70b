#include "lesson/ball_check.hpp"

#include <cmath>

#include "fit/certify.hpp"
#include "geometry/tolerance.hpp"

namespace snug::lesson {
namespace {

template <class Scalar, int Dim>
Sphere<Scalar, Dim> lowered(const fit::Sphere3& ball) {
  return {ball.center.head<Dim>().template cast<Scalar>(), static_cast<Scalar>(ball.radius)};
}

/// The rounding that a ball's numbers carry.
template <class Scalar>
double roundoff(const fit::Sphere3& ball) {
  return tolerance::roundoff<Scalar>(ball.radius + ball.center.cwiseAbs().maxCoeff());
}

}  // namespace

Index count_outside(const AnyPointSet& points, const fit::Sphere3& ball) {
  const auto count = [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) {
    const Vector<double, Dim> center = ball.center.head<Dim>();
    const double limit = ball.radius + tolerance::kBoundaryRoundoffs * roundoff<Scalar>(ball);
    Index outside = 0;
    for (const auto& point : set.span())
      if (scaled_norm<double, Dim>(point.template cast<double>() - center) > limit) ++outside;
    return outside;
  };
  return std::visit(count, points);
}

StepCertificate certify_step(const AnyPointSet& points, const fit::Sphere3& ball, const fit::Support& support) {
  const auto certify = [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) {
    const auto certificate = fit::certify<Scalar, Dim>({lowered<Scalar, Dim>(ball), support}, set.span(), false);
    return StepCertificate{certificate.on_boundary, ball.radius - certificate.lower_bound <=
                                                        tolerance::kOptimalityRoundoffs * roundoff<Scalar>(ball)};
  };
  return std::visit(certify, points);
}

}  // namespace snug::lesson
