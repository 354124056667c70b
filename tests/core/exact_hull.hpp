// Convex hulls by their definition, in rational arithmetic: slow, and shares no line with what it checks.
#pragma once

#include <vector>

#include "core/exact.hpp"

namespace snug::exact {

/// Whether p is a convex combination of the chosen points: none where these are affinely dependent, for then fewer of
/// them do.
template <class Point>
bool in_simplex(const Point& p, const std::vector<Point>& chosen) {
  constexpr std::size_t kDim = Point::RowsAtCompileTime;
  const std::size_t unknowns = chosen.size() - 1;
  const auto at = [](const Point& q, std::size_t axis) {
    return Rational(static_cast<double>(q[static_cast<int>(axis)]));
  };
  // One equation an axis: the sum of weight_i (chosen_i - chosen_0) is p - chosen_0.
  std::vector<std::vector<Rational>> rows(kDim, std::vector<Rational>(unknowns + 1));
  for (std::size_t axis = 0; axis < kDim; ++axis) {
    for (std::size_t i = 0; i < unknowns; ++i) rows[axis][i] = at(chosen[i + 1], axis) - at(chosen[0], axis);
    rows[axis][unknowns] = at(p, axis) - at(chosen[0], axis);
  }
  for (std::size_t k = 0; k < unknowns; ++k) {
    std::size_t pivot = k;
    while (pivot < kDim && rows[pivot][k] == 0) ++pivot;
    if (pivot == kDim) return false;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t row = 0; row < kDim; ++row) {
      if (row == k || rows[row][k] == 0) continue;
      const Rational factor = rows[row][k] / rows[k][k];
      for (std::size_t i = k; i <= unknowns; ++i) rows[row][i] -= factor * rows[k][i];
    }
  }
  for (std::size_t row = unknowns; row < kDim; ++row)
    if (rows[row][unknowns] != 0) return false;
  Rational sum = 0;
  for (std::size_t k = 0; k < unknowns; ++k) {
    const Rational weight = rows[k][unknowns] / rows[k][k];
    if (weight < 0) return false;
    sum += weight;
  }
  return sum <= 1;
}

/// Whether p lies in the convex hull of the points: in that of dim + 1 of them or fewer.
/// Source: C. Carathéodory, "Über den Variabilitätsbereich der Koeffizienten von Potenzreihen", 1907.
template <class Point>
bool in_hull(const Point& p, const std::vector<Point>& points) {
  std::vector<Point> chosen;
  const auto choose = [&](const auto& self, std::size_t first) -> bool {
    if (!chosen.empty() && in_simplex(p, chosen)) return true;
    if (chosen.size() == Point::RowsAtCompileTime + 1) return false;
    for (std::size_t i = first; i < points.size(); ++i) {
      chosen.push_back(points[i]);
      if (self(self, i + 1)) return true;
      chosen.pop_back();
    }
    return false;
  };
  return choose(choose, 0);
}

/// The points that are in no hull of the others, by rising index; of several in one place the first.
template <class Point>
std::vector<Index> extreme_points(const std::vector<Point>& points) {
  std::vector<Index> extreme;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<Point> others;
    bool first = true;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (points[j] != points[i]) others.push_back(points[j]);
      else if (j < i) first = false;
    }
    if (first && !in_hull(points[i], others)) extreme.push_back(static_cast<Index>(i));
  }
  return extreme;
}

}  // namespace snug::exact
