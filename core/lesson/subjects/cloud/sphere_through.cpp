#include "lesson/subjects/cloud/sphere_through.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lesson/point_subject.hpp"
#include "number/double_double.hpp"
#include "number/dyadic.hpp"

namespace snug::lesson {
namespace {

constexpr int kMostEdges = 3;
// A result is sure if it is at least this share of the terms that were summed: the rounding errors of a few dozen
// operations with twice a double's digits are far below it.
constexpr double kSureShare = 0x1p-90;

template <class Number>
using ThreeByThree = std::array<std::array<Number, kMostEdges>, kMostEdges>;
template <class Number>
using Offset = std::array<Number, 3>;

/// q − p, without rounding.
template <class Number>
Offset<Number> offset_to(const Point3& q, const Point3& p) {
  Offset<Number> offset;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double to = q[static_cast<int>(axis)], from = p[static_cast<int>(axis)];
    if constexpr (std::is_same_v<Number, Dyadic>) offset[axis] = Dyadic(to) - Dyadic(from);
    else offset[axis] = DoubleDouble::sum(to, -from);
  }
  return offset;
}

template <class Number>
Number product_of(const Offset<Number>& a, const Offset<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Number determinant(const ThreeByThree<Number>& m, int n) {
  if (n == 0) return Number(1.0);
  if (n == 1) return m[0][0];
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t top) {
    return m[top][i] * m[top + 1][j] - m[top][j] * m[top + 1][i];
  };
  if (n == 2) return minor(0, 1, 0);
  return m[0][0] * minor(1, 2, 1) - m[0][1] * minor(0, 2, 1) + m[0][2] * minor(0, 1, 1);
}

/// Uses Cramer's rule: with the edges e from the first support point p, the centre is p + sum x e, where the matrix of
/// 2 e·e times x is the vector of the e·e. A point p + d is outside if |d|² exceeds 2 d·(centre − p).
template <class Number>
struct Sides {
  Number whole;         // the matrix's determinant: 0 where the set is affinely dependent, else above 0
  Number excess;        // |d|² − 2 d·(centre − p), times that
  double greatest = 0;  // bounds on the size of what is summed up for the two
  double summed = 0;
};

template <class Number>
Sides<Number> sides_of(const AnyPointSet& points, const fit::Support& support, Index point) {
  const int n = support.size() - 1;
  const Point3 base = fit::point_of(points, support[0]);
  std::array<Offset<Number>, kMostEdges> edges;
  for (int i = 0; i < n; ++i) edges[i] = offset_to<Number>(fit::point_of(points, support[i + 1]), base);
  ThreeByThree<Number> matrix;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) matrix[i][j] = Number(2.0) * product_of(edges[i], edges[j]);
  const Offset<Number> d = offset_to<Number>(fit::point_of(points, point), base);
  Sides<Number> sides{determinant(matrix, n), determinant(matrix, n) * product_of(d, d)};
  for (int k = 0; k < n; ++k) {
    ThreeByThree<Number> own = matrix;
    for (int i = 0; i < n; ++i) own[i][k] = product_of(edges[i], edges[i]);
    sides.excess -= Number(2.0) * determinant(own, n) * product_of(d, edges[k]);
  }
  if constexpr (std::is_same_v<Number, DoubleDouble>) {
    double entry = 0;
    for (int i = 0; i < n; ++i) entry = std::max(entry, matrix[i][i].high);
    const double length = std::sqrt(product_of(d, d).high);
    sides.greatest = 6 * std::pow(entry, n);
    sides.summed = sides.greatest * (length * length + 6 * length * std::sqrt(entry));
  }
  return sides;
}

int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

}  // namespace

std::optional<int> SphereThrough::side(Index point) const {
  const auto quick = sides_of<DoubleDouble>(points_, support_, point);
  if (quick.whole.high > kSureShare * quick.greatest && std::abs(quick.excess.high) > kSureShare * quick.summed)
    return sign_of(quick.excess.high);
  const auto exact = sides_of<Dyadic>(points_, support_, point);
  if (exact.whole.sign() == 0) return std::nullopt;
  return exact.excess.sign();
}

}  // namespace snug::lesson
