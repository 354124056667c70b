// How far a k-DOP reaches on both sides of a plane, without its vertices: by duality of linear programs.
#pragma once

#include <optional>
#include <utility>

#include "geometry/kdop.hpp"
#include "geometry/reach.hpp"
#include "number/dyadic.hpp"

namespace snug {

/// Dim axes of a k-DOP, and the normal as a sum of them: normal = sum weights[j] axis[j] / determinant.
template <class Number, int Dim>
struct NormalAsAxes {
  std::array<Number, Dim> weights;
  int determinant = 0;  // that of the axes, made positive; 0 if they are dependent
};

template <class Number, class Scalar>
[[nodiscard]] NormalAsAxes<Number, 2> as_axes(const Vector<Scalar, 2>& n,
                                              const std::array<std::array<int, 2>, 2>& axes) {
  const auto [a, b] = axes;
  const int determinant = a[0] * b[1] - a[1] * b[0], sign = determinant < 0 ? -1 : 1;
  const auto weight = [&](int x, int y) {
    return exactly<Number>(n[0]) * exactly<Number>(Scalar(sign * x)) +
           exactly<Number>(n[1]) * exactly<Number>(Scalar(sign * y));
  };
  return {{weight(b[1], -b[0]), weight(-a[1], a[0])}, sign * determinant};
}

template <class Number, class Scalar>
[[nodiscard]] NormalAsAxes<Number, 3> as_axes(const Vector<Scalar, 3>& n,
                                              const std::array<std::array<int, 3>, 3>& axes) {
  const auto cross = [&](std::size_t i, std::size_t j) {
    const auto &a = axes[i], &b = axes[j];
    return std::array<int, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto first = cross(1, 2);
  const int determinant = axes[0][0] * first[0] + axes[0][1] * first[1] + axes[0][2] * first[2],
            sign = determinant < 0 ? -1 : 1;
  const auto weight = [&](const std::array<int, 3>& across) {
    Number sum = exactly<Number>(n[0]) * exactly<Number>(Scalar(sign * across[0]));
    for (int i = 1; i < 3; ++i) sum += exactly<Number>(n[i]) * exactly<Number>(Scalar(sign * across[i]));
    return sum;
  };
  return {{weight(first), weight(cross(2, 0)), weight(cross(0, 1))}, sign * determinant};
}

/// x / n. Exact numbers stay integers, and are multiplied by a common denominator instead.
template <class Scalar>
[[nodiscard]] Scalar over(Scalar x, int n) {
  return x / static_cast<Scalar>(n);
}
/// Determinants of axes are 1, 2, 3 or 4, so all quotients times 12 are integers.
inline constexpr int kCommonDenominator = 12;
[[nodiscard]] inline Dyadic over(const Dyadic& x, int n) { return x * Dyadic(kCommonDenominator / n); }

/// The greatest of n . p over the k-DOP is the least of the bounds that any Dim independent axes give: the normal is a
/// weighted sum of these axes, and the sign of each weight selects max or min. (These are the vertices of the dual
/// program.) Exact numbers come out times 12, which changes no sign.
template <class Number, class Scalar, int Dim>
[[nodiscard]] Span<Number> core_span(const Plane<Scalar, Dim>& plane, const Kdop<Scalar, Dim>& kdop) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  std::optional<Span<Number>> span;
  const auto meet = [&](const std::array<std::size_t, Dim>& at) {
    std::array<std::array<int, Dim>, Dim> chosen;
    for (std::size_t j = 0; j < Dim; ++j) chosen[j] = axes[at[j]];
    const auto sum = as_axes<Number>(plane.normal, chosen);
    if (sum.determinant == 0) return;
    Number low(0), high(0);
    for (std::size_t j = 0; j < Dim; ++j) {
      const bool up = !(sum.weights[j] < Number(0));
      low += sum.weights[j] * exactly<Number>(up ? kdop.min[at[j]] : kdop.max[at[j]]);
      high += sum.weights[j] * exactly<Number>(up ? kdop.max[at[j]] : kdop.min[at[j]]);
    }
    low = over(low, sum.determinant);
    high = over(high, sum.determinant);
    if (!span) span = Span<Number>{low, high};
    if (span->low < low) span->low = low;
    if (high < span->high) span->high = high;
  };
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t j = i + 1; j < axes.size(); ++j) {
      if constexpr (Dim == 2) meet({i, j});
      else
        for (std::size_t k = j + 1; k < axes.size(); ++k) meet({i, j, k});
    }
  if (span->high < span->low) std::swap(span->low, span->high);  // slabs that have no common point because of rounding
  const Number d = over(exactly<Number>(plane.d), 1);
  return {span->low + d, span->high + d};
}

}  // namespace snug
