// Vectors of any kind of number, exact or rounded.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/vector.hpp"

namespace snug::query {

template <class Number, int Dim>
using Numbers = std::array<Number, Dim>;

/// A vector's coordinates, which convert without loss.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Numbers<Number, Dim> numbers(const Vector<Scalar, Dim>& v) {
  Numbers<Number, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = Number(static_cast<double>(v[i]));
  return result;
}

template <class Number, std::size_t Dim>
[[nodiscard]] Number dot(const std::array<Number, Dim>& a, const std::array<Number, Dim>& b) {
  Number sum = a[0] * b[0];
  for (std::size_t i = 1; i < Dim; ++i) sum += a[i] * b[i];
  return sum;
}

template <class Number>
[[nodiscard]] std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace snug::query
