// How far a volume reaches on both sides of a plane: the least and greatest of normal . p + d over its points, rounded
// and exactly.
#pragma once

#include <limits>
#include <type_traits>

#include "geometry/aabb_forms.hpp"
#include "geometry/kdop_reach.hpp"
#include "geometry/tolerance.hpp"
#include "query/distance/support_function.hpp"

namespace snug::query {

/// A shape whose header says how far it reaches in numbers that never round: a volume or a point.
template <class Shape, class Plane>
concept ReachesExactly = requires(const Shape& shape, const Plane& plane) {
  core_span<Dyadic>(plane, shape);
};

/// |normal|, within 3u.
template <class Scalar, int Dim>
[[nodiscard]] Scalar length_of(const Plane<Scalar, Dim>& plane) {
  return std::sqrt(dot_as<Scalar, Scalar, Dim>(plane.normal, plane.normal));
}

/// The core's span, rounded, of a volume that is known by its support mapping alone.
template <class Shape, class Scalar, int Dim>
[[nodiscard]] Span<Scalar> supported_span(const Plane<Scalar, Dim>& plane, const Shape& volume) {
  const Vector<double, Dim> normal = plane.normal.template cast<double>();
  const Vector<Scalar, Dim> origin = anchor(volume);
  const Vector<double, Dim> towards = normal / normal.cwiseAbs().maxCoeff();
  const double middle = signed_distance(plane, origin);
  const auto value = [&](const Vector<double, Dim>& way) {
    return static_cast<Scalar>(middle + normal.dot(farthest_of_core(volume, origin, way)));
  };
  return {value(-towards), value(towards)};
}

/// The whole volume's span, rounded.
template <class Shape, class Scalar, int Dim>
[[nodiscard]] Span<Scalar> span_of(const Plane<Scalar, Dim>& plane, const Shape& volume) {
  Span<Scalar> span = [&] {
    if constexpr (ReachesExactly<Shape, Plane<Scalar, Dim>>) return core_span<Scalar>(plane, volume);
    else return supported_span(plane, volume);
  }();
  if constexpr (HasRadius<Shape>) {
    const Scalar radius = core_radius(volume) * length_of(plane);
    span.low -= radius;
    span.high += radius;
  }
  return span;
}

/// The size that a span's rounding is relative to: at least every coordinate that enters the span, times the sum of
/// their weights. If only a support mapping is known, four times the largest coordinate: the mapping is off by as much
/// as the sum may be, the anchor is added, and the box around the volume is rounded itself. Tested by "culling by a
/// support mapping alone is never wrong".
template <class Shape>
[[nodiscard]] auto span_size(const Shape& volume) {
  if constexpr (requires { magnitude_of(volume); }) {
    return magnitude_of(volume);
  } else {
    using Scalar = typename VolumeKind<Shape>::Scalar;
    const auto box = box_around(volume);
    return static_cast<Scalar>(4 * std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()));
  }
}

/// The error bound of both ends of span_of. size: span_size of the volume.
template <class Scalar, int Dim>
[[nodiscard]] Scalar error_bound_of(const Plane<Scalar, Dim>& plane, Scalar size) {
  Scalar sizes = std::abs(plane.normal[0]);
  for (int i = 1; i < Dim; ++i) sizes += std::abs(plane.normal[i]);
  return tolerance::kPlaneReach<Scalar> * (sizes * size + std::abs(plane.d)) + std::numeric_limits<Scalar>::min();
}

/// The sign of value - radius |normal|. square: (radius |normal|)^2.
[[nodiscard]] inline int sign_less_radius(const Dyadic& value, const Dyadic& square) {
  if (value.sign() > 0) return (value * value - square).sign();
  return square.sign() > 0 ? -1 : value.sign();
}

/// The signs of both ends of the whole volume's span, exactly. If only its support mapping is known, they are those of
/// a volume that lies on both sides, so that nothing within the error bound is said to be outside or inside.
template <class Shape, class Scalar, int Dim>
[[nodiscard]] Span<int> signs_of(const Plane<Scalar, Dim>& plane, const Shape& volume) {
  if constexpr (!ReachesExactly<Shape, Plane<Scalar, Dim>>) {
    return {-1, 1};
  } else if constexpr (HasRadius<Shape>) {
    const Span<Dyadic> span = core_span<Dyadic>(plane, volume);
    const Dyadic radius = static_cast<double>(core_radius(volume));
    const Dyadic square = radius * radius * dot_as<Dyadic, Scalar, Dim>(plane.normal, plane.normal);
    return {sign_less_radius(span.low, square), -sign_less_radius(-span.high, square)};
  } else {
    const Span<Dyadic> span = core_span<Dyadic>(plane, volume);
    return {span.low.sign(), span.high.sign()};
  }
}

}  // namespace snug::query
