// Vectors of any kind of number, exact or rounded. (Those of doubles and floats that the rooms above pass around are
// Eigen's: geometry/vector.hpp.)
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace snug {

template <class Number, std::size_t Dim>
using Tuple = std::array<Number, Dim>;

/// A vector's coordinates as Numbers, which must keep all of their digits.
template <class Number, std::size_t Dim>
[[nodiscard]] constexpr Tuple<Number, Dim> tuple_of(const auto& v) {
  Tuple<Number, Dim> result;
  for (std::size_t i = 0; i < Dim; ++i) result[i] = Number(static_cast<double>(v[static_cast<int>(i)]));
  return result;
}

/// f of each index, without a loop: these are the innermost operations of some algorithms.
template <class Number, std::size_t Dim>
[[nodiscard]] constexpr Tuple<Number, Dim> each_of(auto&& f) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) { return Tuple<Number, Dim>{f(i)...}; }
  (std::make_index_sequence<Dim>());
}

template <class Number, std::size_t Dim>
[[nodiscard]] constexpr Tuple<Number, Dim> operator+(const Tuple<Number, Dim>& a, const Tuple<Number, Dim>& b) {
  return each_of<Number, Dim>([&](std::size_t i) { return a[i] + b[i]; });
}
template <class Number, std::size_t Dim>
[[nodiscard]] constexpr Tuple<Number, Dim> operator-(const Tuple<Number, Dim>& a, const Tuple<Number, Dim>& b) {
  return each_of<Number, Dim>([&](std::size_t i) { return a[i] - b[i]; });
}
template <class Number, std::size_t Dim>
[[nodiscard]] constexpr Tuple<Number, Dim> operator*(const Number& s, const Tuple<Number, Dim>& a) {
  return each_of<Number, Dim>([&](std::size_t i) { return s * a[i]; });
}

/// Summed from the first coordinate to the last.
template <class Number, std::size_t Dim>
[[nodiscard]] constexpr Number dot(const Tuple<Number, Dim>& a, const Tuple<Number, Dim>& b) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) { return (... + (a[i] * b[i])); }
  (std::make_index_sequence<Dim>());
}

/// a, b: anything with three coordinates; Eigen's vectors too.
template <class Triple>
[[nodiscard]] constexpr Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace snug
