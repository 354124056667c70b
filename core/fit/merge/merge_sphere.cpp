#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fit/merge/merge.hpp"
#include "query/overlap/overlaps_spheres.hpp"

namespace snug::fit {
namespace {

/// Whether the larger sphere contains the smaller: the centres are at most the radii's difference apart, exactly.
template <class Scalar, int Dim>
bool holds(const Sphere<Scalar, Dim>& outer, const Sphere<Scalar, Dim>& inner) {
  return inner.radius <= outer.radius &&
         !query::apart_exactly<Scalar, Dim>(outer.center, outer.radius, inner.center, -inner.radius);
}

template <class Scalar, int Dim>
bool comes_first(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b) {
  if (a.radius != b.radius) return a.radius > b.radius;
  for (int i = 0; i < Dim; ++i)
    if (a.center[i] != b.center[i]) return a.center[i] < b.center[i];
  return true;
}

}  // namespace

template <class Scalar, int Dim>
Sphere<Scalar, Dim> merge(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b) {
  const bool a_first = comes_first(a, b);
  const Sphere<Scalar, Dim>& large = a_first ? a : b;
  const Sphere<Scalar, Dim>& small = a_first ? b : a;
  if (holds(large, small)) return large;

  // The diameter runs from the far side of the large ball through both centres to the far side of the small one.
  const Vector<double, Dim> from = large.center.template cast<double>();
  const Vector<double, Dim> way = small.center.template cast<double>() - from;
  const auto large_radius = static_cast<double>(large.radius), small_radius = static_cast<double>(small.radius);
  const double distance = scaled_norm<double, Dim>(way);
  const double share = std::clamp(((distance - large_radius) + small_radius) / 2 / distance, 0.0, 1.0);
  Sphere<Scalar, Dim> merged{(from + way * share).template cast<Scalar>(), 0};
  const auto reach = [&](const Sphere<Scalar, Dim>& ball) {
    const Vector<double, Dim> to = ball.center.template cast<double>() - merged.center.template cast<double>();
    return static_cast<Scalar>(scaled_norm<double, Dim>(to) + static_cast<double>(ball.radius));
  };
  merged.radius = std::max(reach(large), reach(small));
  while (!holds(merged, large) || !holds(merged, small))  // a few ulps
    merged.radius = std::nextafter(merged.radius, std::numeric_limits<Scalar>::max());
  return merged;
}

template Sphere<float, 2> merge(const Sphere<float, 2>&, const Sphere<float, 2>&);
template Sphere<float, 3> merge(const Sphere<float, 3>&, const Sphere<float, 3>&);
template Sphere<double, 2> merge(const Sphere<double, 2>&, const Sphere<double, 2>&);
template Sphere<double, 3> merge(const Sphere<double, 3>&, const Sphere<double, 3>&);

}  // namespace snug::fit
