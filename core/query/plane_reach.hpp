// How far a volume reaches on both sides of a plane: the least and greatest of normal . p + d over its points. Written
// once, for rounded numbers and for those that never round.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "geometry/aabb_forms.hpp"
#include "geometry/plane.hpp"
#include "geometry/tolerance.hpp"
#include "geometry/volume.hpp"
#include "number/dyadic.hpp"

namespace snug::query {

/// The least and greatest value, of Scalar or Dyadic.
template <class Number>
struct Span {
  Number low, high;
};

[[nodiscard]] inline float magnitude(float x) { return std::abs(x); }
[[nodiscard]] inline double magnitude(double x) { return std::abs(x); }
[[nodiscard]] inline Dyadic magnitude(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

/// A coordinate as another kind of number, never rounded.
template <class Number, class Scalar>
[[nodiscard]] Number exactly(Scalar x) {
  if constexpr (std::is_same_v<Number, Scalar>) return x;
  else return Number(static_cast<double>(x));
}

/// a . b, summed from the first coordinate to the last.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Number dot_as(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
  Number sum = exactly<Number>(a[0]) * exactly<Number>(b[0]);
  for (int i = 1; i < Dim; ++i) sum += exactly<Number>(a[i]) * exactly<Number>(b[i]);
  return sum;
}
template <class Number, class Scalar, int Dim>
[[nodiscard]] Number value_at(const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& p) {
  return dot_as<Number, Scalar, Dim>(plane.normal, p) + exactly<Number>(plane.d);
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> around(const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& center,
                                  const Number& radius) {
  const Number middle = value_at<Number>(plane, center);
  return {middle - radius, middle + radius};
}

// ---- the span over a volume's core; a point's, a sphere's and a capsule's radius comes on top of it

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& point) {
  const Number value = value_at<Number>(plane, point);
  return {value, value};
}
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Sphere<Scalar, Dim>& sphere) {
  return core_span<Number>(plane, sphere.center);
}

/// Each coordinate of the normal chooses from min and max by its sign: that is the n-vertex, and the other the
/// p-vertex.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Aabb<Scalar, Dim>& box) {
  Vector<Scalar, Dim> n_vertex, p_vertex;
  for (int i = 0; i < Dim; ++i) {
    const bool towards_max = plane.normal[i] >= 0;
    n_vertex[i] = towards_max ? box.min[i] : box.max[i];
    p_vertex[i] = towards_max ? box.max[i] : box.min[i];
  }
  return {value_at<Number>(plane, n_vertex), value_at<Number>(plane, p_vertex)};
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const AabbCenterExtents<Scalar, Dim>& box) {
  const Vector<Scalar, Dim> sizes = plane.normal.cwiseAbs();
  return around<Number>(plane, box.center, dot_as<Number, Scalar, Dim>(sizes, box.half_extents));
}

/// The normal's coordinate along a box's axis.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Number along_axis(const Plane<Scalar, Dim>& plane, const Obb<Scalar, Dim>& box, int axis) {
  return dot_as<Number, Scalar, Dim>(plane.normal, Vector<Scalar, Dim>(box.axes.col(axis)));
}

/// The normal in the box's frame: from the centre to a vertex, each half extent counts with or against it.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Obb<Scalar, Dim>& box) {
  Number radius = magnitude(along_axis<Number>(plane, box, 0)) * exactly<Number>(box.half_extents[0]);
  for (int i = 1; i < Dim; ++i)
    radius += magnitude(along_axis<Number>(plane, box, i)) * exactly<Number>(box.half_extents[i]);
  return around<Number>(plane, box.center, radius);
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Capsule<Scalar, Dim>& capsule) {
  const Number a = value_at<Number>(plane, capsule.a), b = value_at<Number>(plane, capsule.b);
  return a < b ? Span<Number>{a, b} : Span<Number>{b, a};
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Lozenge<Scalar, Dim>& lozenge) {
  Span<Number> span = core_span<Number>(plane, lozenge.origin);
  for (const auto& edge : lozenge.edges) {
    const Number step = dot_as<Number, Scalar, Dim>(plane.normal, edge);
    (step < Number(0) ? span.low : span.high) += step;
  }
  return span;
}

template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const ConvexHull<Scalar, Dim>& hull) {
  Span<Number> span = core_span<Number>(plane, hull.vertices.front());
  for (const auto& vertex : hull.vertices) {
    const Number value = value_at<Number>(plane, vertex);
    if (value < span.low) span.low = value;
    if (span.high < value) span.high = value;
  }
  return span;
}

/// For k-DOPs see plane_reach_kdop.hpp.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Kdop<Scalar, Dim>& kdop);

// ---- the radius on top

template <class Scalar, int Dim>
[[nodiscard]] Scalar radius_of(const Sphere<Scalar, Dim>& sphere) {
  return sphere.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar radius_of(const Capsule<Scalar, Dim>& capsule) {
  return capsule.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar radius_of(const Lozenge<Scalar, Dim>& lozenge) {
  return lozenge.radius;
}
template <class Shape>
inline constexpr bool kHasRadius = requires(const Shape& shape) {
  radius_of(shape);
};

// ---- a volume's size: no less than any coordinate that enters its span, in the sum of their weights

template <class Scalar, int Dim>
[[nodiscard]] Scalar largest(const Vector<Scalar, Dim>& v) {
  Scalar most = std::abs(v[0]);
  for (int i = 1; i < Dim; ++i) most = std::max(most, std::abs(v[i]));
  return most;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Vector<Scalar, Dim>& point) {
  return largest<Scalar, Dim>(point);
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Sphere<Scalar, Dim>& sphere) {
  return largest<Scalar, Dim>(sphere.center) + sphere.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Aabb<Scalar, Dim>& box) {
  return std::max(largest<Scalar, Dim>(box.min), largest<Scalar, Dim>(box.max));
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const AabbCenterExtents<Scalar, Dim>& box) {
  return largest<Scalar, Dim>(box.center) + largest<Scalar, Dim>(box.half_extents);
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Obb<Scalar, Dim>& box) {
  return largest<Scalar, Dim>(box.center) + box.half_extents.sum();
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Capsule<Scalar, Dim>& capsule) {
  return std::max(largest<Scalar, Dim>(capsule.a), largest<Scalar, Dim>(capsule.b)) + capsule.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Lozenge<Scalar, Dim>& lozenge) {
  return largest<Scalar, Dim>(lozenge.origin) + largest<Scalar, Dim>(lozenge.edges[0]) +
         largest<Scalar, Dim>(lozenge.edges[1]) + lozenge.radius;
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const ConvexHull<Scalar, Dim>& hull) {
  Scalar most = 0;
  for (const auto& vertex : hull.vertices) most = std::max(most, largest<Scalar, Dim>(vertex));
  return most;
}
/// The span is a sum of bounds whose weights' sizes sum up to no more than 6 times the normal's (plane_reach_kdop.hpp).
template <class Scalar, int Dim>
[[nodiscard]] Scalar size_of(const Kdop<Scalar, Dim>& kdop) {
  Scalar most = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(kdop.k / 2); ++i)
    most = std::max({most, std::abs(kdop.min[i]), std::abs(kdop.max[i])});
  return 6 * most;
}

// ---- what rounding leaves open

/// |normal|, within 3u.
template <class Scalar, int Dim>
[[nodiscard]] Scalar length_of(const Plane<Scalar, Dim>& plane) {
  return std::sqrt(dot_as<Scalar, Scalar, Dim>(plane.normal, plane.normal));
}

/// The whole volume's span, rounded.
template <class Shape, class Scalar, int Dim>
[[nodiscard]] Span<Scalar> span_of(const Plane<Scalar, Dim>& plane, const Shape& volume) {
  Span<Scalar> span = core_span<Scalar>(plane, volume);
  if constexpr (kHasRadius<Shape>) {
    const Scalar radius = radius_of(volume) * length_of(plane);
    span.low -= radius;
    span.high += radius;
  }
  return span;
}

/// Within what both ends of span_of are known. size: size_of the volume.
template <class Scalar, int Dim>
[[nodiscard]] Scalar doubt_of(const Plane<Scalar, Dim>& plane, Scalar size) {
  Scalar sizes = std::abs(plane.normal[0]);
  for (int i = 1; i < Dim; ++i) sizes += std::abs(plane.normal[i]);
  return tolerance::kPlaneReach<Scalar> * (sizes * size + std::abs(plane.d)) + std::numeric_limits<Scalar>::min();
}

/// The sign of value - radius |normal|, where square is that product's square.
[[nodiscard]] inline int sign_less_radius(const Dyadic& value, const Dyadic& square) {
  if (value.sign() > 0) return (value * value - square).sign();
  return square.sign() > 0 ? -1 : value.sign();
}

/// The signs of both ends of the whole volume's span, exactly.
template <class Shape, class Scalar, int Dim>
[[nodiscard]] Span<int> signs_of(const Plane<Scalar, Dim>& plane, const Shape& volume) {
  const Span<Dyadic> span = core_span<Dyadic>(plane, volume);
  if constexpr (kHasRadius<Shape>) {
    const Dyadic radius = static_cast<double>(radius_of(volume));
    const Dyadic square = radius * radius * dot_as<Dyadic, Scalar, Dim>(plane.normal, plane.normal);
    return {sign_less_radius(span.low, square), -sign_less_radius(-span.high, square)};
  } else {
    return {span.low.sign(), span.high.sign()};
  }
}

}  // namespace snug::query
