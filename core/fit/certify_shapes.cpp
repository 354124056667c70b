#include "fit/certify_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "fit/swept/swept_radius.hpp"
#include "geometry/kdop_project.hpp"
#include "geometry/tolerance.hpp"
#include "query/contains.hpp"

namespace snug::fit {
namespace {

template <class VolumeType, class Scalar, int Dim>
Certificate containment(const VolumeType& volume, PointSpan<Scalar, Dim> points) {
  Certificate certificate;
  for (const auto& p : points) {
    const double outside = query::outside_by(volume, p);
    certificate.outside += outside > 0 ? 1 : 0;
    certificate.max_outside = std::max(certificate.max_outside, outside);
  }
  certificate.contains = certificate.outside == 0;
  return certificate;
}

/// Which bounds the point lies on: bit 2 i for the least along axis i, bit 2 i + 1 for the greatest.
template <class Scalar, int Dim>
unsigned held_bounds(const Kdop<Scalar, Dim>& kdop, const Vector<Scalar, Dim>& p) {
  unsigned held = 0;
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (project_down<Scalar, Dim>(axes[i], p) == kdop.min[i]) held |= 1u << 2 * i;
    if (project_up<Scalar, Dim>(axes[i], p) == kdop.max[i]) held |= 2u << 2 * i;
  }
  return held;
}

template <class Scalar, int Dim>
unsigned held_bounds(const Aabb<Scalar, Dim>& box, const Vector<Scalar, Dim>& p) {
  unsigned held = 0;
  for (int i = 0; i < Dim; ++i) {
    if (p[i] == box.min[i]) held |= 1u << 2 * i;
    if (p[i] == box.max[i]) held |= 2u << 2 * i;
  }
  return held;
}

/// bounds: the number of bounds that the volume has.
template <class VolumeType, class Scalar, int Dim>
Certificate certify_bounds(const Fit<VolumeType>& fit, PointSpan<Scalar, Dim> points, int bounds, bool claims_optimal) {
  Certificate certificate = containment(fit.volume, points);
  unsigned all = 0;
  certificate.on_boundary = true;
  for (const Index i : fit.support) {
    const unsigned held = held_bounds(fit.volume, points[i]);
    certificate.on_boundary = certificate.on_boundary && held != 0;
    all |= held;
  }
  if (claims_optimal) certificate.optimal = certificate.contains && all == (1u << bounds) - 1;
  return certificate;
}

template <class VolumeType, class Scalar, int Dim>
Certificate certify_swept(const Fit<VolumeType>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  Certificate certificate = containment(fit.volume, points);
  const double size = swept_size(fit.volume, points);
  certificate.on_boundary = std::all_of(fit.support.begin(), fit.support.end(),
                                        [&](Index i) { return touches(fit.volume, points[i], size); });
  if (claims_optimal) certificate.optimal = false;
  return certificate;
}

}  // namespace

template <class Scalar, int Dim>
Certificate certify(const Fit<Aabb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  return certify_bounds(fit, points, 2 * Dim, claims_optimal);
}

template <class Scalar, int Dim>
Certificate certify(const Fit<Kdop<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  return certify_bounds(fit, points, fit.volume.k, claims_optimal);
}

template <class Scalar, int Dim>
Certificate certify(const Fit<Capsule<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  return certify_swept(fit, points, claims_optimal);
}

template <class Scalar, int Dim>
Certificate certify(const Fit<Lozenge<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  return certify_swept(fit, points, claims_optimal);
}

#define SNUG_INSTANTIATE(Volume, Scalar, Dim)                                                                          \
  template Certificate certify(const Fit<Volume<Scalar, Dim>>&, PointSpan<Scalar, Dim>, bool);
#define SNUG_INSTANTIATE_ALL(Volume)                                                                                   \
  SNUG_INSTANTIATE(Volume, float, 2)                                                                                   \
  SNUG_INSTANTIATE(Volume, float, 3)                                                                                   \
  SNUG_INSTANTIATE(Volume, double, 2)                                                                                  \
  SNUG_INSTANTIATE(Volume, double, 3)
SNUG_INSTANTIATE_ALL(Aabb)
SNUG_INSTANTIATE_ALL(Kdop)
SNUG_INSTANTIATE_ALL(Capsule)
SNUG_INSTANTIATE_ALL(Lozenge)
#undef SNUG_INSTANTIATE_ALL
#undef SNUG_INSTANTIATE

}  // namespace snug::fit
