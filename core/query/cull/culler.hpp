// The verdict alone of a sphere or an axis-aligned box against a frustum, for many volumes against the same planes:
// what depends on the planes alone is prepared once, and no result is built. Its source is that of classify.hpp.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "geometry/tolerance.hpp"
#include "query/cull/classify.hpp"

namespace snug::query {

/// A frustum prepared for many verdicts, each of them that of classify: the planes decide where rounding cannot change
/// the answer, and classify decides the rest. The frustum must outlive it.
template <class Scalar, int Dim>
class Culler {
 public:
  explicit Culler(const Frustum<Scalar, Dim>& frustum) : frustum_(frustum) {
    for (int i = 0; i < kFrustumPlanes<Dim>; ++i) {
      const Plane<Scalar, Dim>& plane = frustum[i];
      const Scalar length = length_of(plane);
      planes_[i] = {plane.normal / length, plane.d / length};
      farthest_ = std::max(farthest_, std::abs(plane.d / length));
    }
  }

  [[nodiscard, gnu::flatten]] Culling operator()(const Sphere<Scalar, Dim>& sphere) const {
    const Scalar error_bound = error_bound_of(magnitude_of(sphere)), most = sphere.radius + error_bound,
                 least = sphere.radius - error_bound;
    Culling verdict = Culling::kInside;
    for (const Plane<Scalar, Dim>& plane : planes_) {
      const Scalar value = plane.normal.dot(sphere.center) + plane.d;
      if (value > most) return Culling::kOutside;
      if (value < -most) continue;
      if (!(std::abs(value) < least)) [[unlikely]]
        return closely(sphere);
      verdict = Culling::kIntersecting;
    }
    return verdict;
  }

  [[nodiscard, gnu::flatten]] Culling operator()(const Aabb<Scalar, Dim>& box) const {
    const Scalar error_bound = error_bound_of(magnitude_of(box));
    Culling verdict = Culling::kInside;
    for (const Plane<Scalar, Dim>& plane : planes_) {
      Scalar low = plane.d, high = plane.d;
      for (int i = 0; i < Dim; ++i) {
        const bool towards_max = plane.normal[i] >= 0;
        low += plane.normal[i] * (towards_max ? box.min[i] : box.max[i]);
        high += plane.normal[i] * (towards_max ? box.max[i] : box.min[i]);
      }
      if (low > error_bound) return Culling::kOutside;
      if (high < -error_bound) continue;
      if (!(low < -error_bound && high > error_bound)) [[unlikely]]
        return closely(box);
      verdict = Culling::kIntersecting;
    }
    return verdict;
  }

 private:
  /// The error bound of a value at any of the planes.
  [[nodiscard]] Scalar error_bound_of(Scalar size) const {
    return tolerance::kUnitPlaneReach<Scalar> * (2 * size + farthest_) + std::numeric_limits<Scalar>::min();
  }

  template <class Shape>
  [[gnu::cold, gnu::noinline]] Culling closely(const Shape& shape) const {
    return classify(frustum_, shape).verdict;
  }

  const Frustum<Scalar, Dim>& frustum_;
  std::array<Plane<Scalar, Dim>, kFrustumPlanes<Dim>> planes_;  // unit
  Scalar farthest_ = 0;                                         // of the planes from the origin
};

}  // namespace snug::query
