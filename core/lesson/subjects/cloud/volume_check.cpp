#include "lesson/subjects/cloud/volume_check.hpp"

#include <algorithm>
#include <cmath>

#include "fit/sphere/certify_sphere.hpp"
#include "geometry/convert.hpp"
#include "geometry/tolerance.hpp"
#include "query/contain/contains.hpp"

namespace snug::lesson {
namespace {

/// The rounding error of a ball's numbers.
template <class Scalar>
double roundoff(const fit::Sphere3& ball) {
  return tolerance::roundoff<Scalar>(ball.radius + ball.center.cwiseAbs().maxCoeff());
}

template <class Scalar, int Dim>
Index outside(const PointSet<Scalar, Dim>& set, const fit::Sphere3& ball) {
  const Vector<double, Dim> center = ball.center.head<Dim>();
  const double seen = tolerance::kSeenOutside * ball.radius + tolerance::roundoff<double>(ball.radius);
  const double excused = std::min(tolerance::kBoundaryRoundoffs * roundoff<Scalar>(ball), seen);
  const double limit = ball.radius + excused;
  Index outside = 0;
  for (const auto& point : set.span())
    if (scaled_norm<double, Dim>(point.template cast<double>() - center) > limit) ++outside;
  return outside;
}

/// None: a hull consists of the points themselves and comes only at the end, and what is between slabs contains them.
template <class Scalar, int Dim>
Index outside(const PointSet<Scalar, Dim>&, const ConvexHull<double, 3>&) {
  return 0;
}

/// A lifted planar k-DOP is converted back, because its slabs are those of the plane.
template <class Scalar, int Dim>
Index outside(const PointSet<Scalar, Dim>& set, const Kdop<double, 3>& kdop) {
  const Kdop<double, Dim> own = converted<double, Dim>(kdop);
  Index outside = 0;
  for (const auto& point : set.span()) outside += query::contains(own, point.template cast<double>()) ? 0 : 1;
  return outside;
}

/// In 2-D, volume and points have z = 0.
template <class Scalar, int Dim, class VolumeType>
Index outside(const PointSet<Scalar, Dim>& set, const VolumeType& volume) {
  Index outside = 0;
  for (Index i = 0; i < set.size(); ++i) {
    const Vector<double, 3> point = fit::point_of(set, i);
    const double limit = tolerance::kBoundaryRoundoffs * tolerance::roundoff<Scalar>(point.cwiseAbs().maxCoeff());
    if (query::outside_by(volume, point) > limit) ++outside;
  }
  return outside;
}

}  // namespace

Index count_outside(const AnyPointSet& points, const fit::Volume3& volume) {
  return std::visit(
      [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) {
        return std::visit([&](const auto& kind) { return outside<Scalar, Dim>(set, kind); }, volume);
      },
      points);
}

StepCertificate certify_step(const AnyPointSet& points, const fit::Sphere3& ball, const std::vector<Index>& support) {
  const auto certify = [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) {
    fit::Support held;
    for (const Index i : support) held.add(i);
    const auto certificate = fit::certify<Scalar, Dim>({converted<Scalar, Dim>(ball), held}, set.span(), false);
    return StepCertificate{certificate.on_boundary, ball.radius - certificate.lower_bound <=
                                                        tolerance::kOptimalityRoundoffs * roundoff<Scalar>(ball)};
  };
  return std::visit(certify, points);
}

}  // namespace snug::lesson
