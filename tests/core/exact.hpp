// Rational arithmetic: the oracle that shares no line with what it checks.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::exact {

using Rational = boost::multiprecision::cpp_rational;

template <class Scalar, int Dim>
Rational squared_distance(const Vector<Scalar, Dim>& a, const Vector<Scalar, Dim>& b) {
  Rational sum = 0;
  for (int i = 0; i < Dim; ++i) {
    const Rational d = Rational(static_cast<double>(a[i])) - Rational(static_cast<double>(b[i]));
    sum += d * d;
  }
  return sum;
}

template <class Scalar, int Dim>
Rational squared_distance(const Vector<Scalar, Dim>& a, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (int i = 0; i < Dim; ++i) {
    const Rational d = Rational(static_cast<double>(a[i])) - b[i];
    sum += d * d;
  }
  return sum;
}

struct Ball {
  std::vector<Rational> center;
  Rational square;
};

/// The ball through all of the points with its centre in their affine hull, by Gauss elimination; none where they are
/// affinely dependent.
template <class Point>
std::optional<Ball> ball_through(const std::vector<Point>& support) {
  const auto n = support.size() - 1;
  const auto dim = static_cast<std::size_t>(support[0].size());
  const auto at = [&](std::size_t point, std::size_t axis) {
    return Rational(static_cast<double>(support[point][static_cast<int>(axis)]));
  };
  std::vector<std::vector<Rational>> edges(n, std::vector<Rational>(dim));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t axis = 0; axis < dim; ++axis) edges[i][axis] = at(i + 1, axis) - at(0, axis);
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n + 1));
  const auto dot = [&](std::size_t i, std::size_t j) {
    Rational sum = 0;
    for (std::size_t axis = 0; axis < dim; ++axis) sum += edges[i][axis] * edges[j][axis];
    return sum;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = 2 * dot(i, j);
    rows[i][n] = dot(i, i);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  Ball ball{std::vector<Rational>(dim), 0};
  for (std::size_t axis = 0; axis < dim; ++axis) {
    for (std::size_t i = 0; i < n; ++i) ball.center[axis] += rows[i][n] / rows[i][i] * edges[i][axis];
    ball.square += ball.center[axis] * ball.center[axis];
    ball.center[axis] += at(0, axis);
  }
  return ball;
}

/// The squared radius of the smallest enclosing ball: the smallest ball through 1 to dim + 1 points that holds all.
template <class Point>
Rational smallest_square(const std::vector<Point>& points) {
  constexpr int kDim = Point::RowsAtCompileTime;
  std::optional<Rational> best;
  std::vector<Point> support;
  const auto holds_all = [&](const Ball& ball) {
    for (const Point& p : points)
      if (squared_distance<typename Point::Scalar, kDim>(p, ball.center) > ball.square) return false;
    return true;
  };
  const auto choose = [&](const auto& self, std::size_t first) -> void {
    if (!support.empty()) {
      const auto ball = ball_through(support);
      if (!ball) return;  // nor is any superset independent
      if ((!best || ball->square < *best) && holds_all(*ball)) best = ball->square;
    }
    if (support.size() == kDim + 1) return;
    for (std::size_t i = first; i < points.size(); ++i) {
      support.push_back(points[i]);
      self(self, i + 1);
      support.pop_back();
    }
  };
  choose(choose, 0);
  return *best;
}

}  // namespace snug::exact
