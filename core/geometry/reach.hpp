// What headers of volumes need to say how far a core reaches on both sides of a plane: the least and greatest of
// normal . p + d over its points. Each says it once, for rounded numbers and for those that never round.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "geometry/plane.hpp"
#include "number/dyadic.hpp"

namespace snug {

/// The least and greatest value, of a Scalar or of Dyadic.
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

template <class Scalar, int Dim>
[[nodiscard]] Scalar largest(const Vector<Scalar, Dim>& v) {
  Scalar most = std::abs(v[0]);
  for (int i = 1; i < Dim; ++i) most = std::max(most, std::abs(v[i]));
  return most;
}

/// A point's span and size, as those of a volume.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& point) {
  const Number value = value_at<Number>(plane, point);
  return {value, value};
}
template <class Scalar, int Dim>
[[nodiscard]] Scalar magnitude_of(const Vector<Scalar, Dim>& point) {
  return largest<Scalar, Dim>(point);
}

}  // namespace snug
