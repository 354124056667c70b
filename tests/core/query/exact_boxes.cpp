#include "core/query/exact_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/exact.hpp"

namespace snug::exact {

namespace {

using Integer = boost::multiprecision::cpp_int;
template <int Dim>
using IntegerVector = std::array<Integer, Dim>;

/// value times 2^shift, which must be whole.
inline Integer scaled(double value, int shift) {
  if (value == 0) return 0;
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int left = exponent - 53 + shift;
  return left >= 0 ? Integer(mantissa) << left : Integer(mantissa) >> -left;
}

/// The weight of the last bit of any number of the box.
template <int Dim>
int lowest_bit(const Obb<double, Dim>& box) {
  int lowest = 0;
  const auto see = [&](double value) {
    if (value == 0) return;
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    lowest = std::min(lowest, exponent - 53 + __builtin_ctzll(static_cast<unsigned long long>(mantissa)));
  };
  for (int i = 0; i < Dim; ++i) {
    see(box.center[i]), see(box.half_extents[i]);
    for (int j = 0; j < Dim; ++j) see(box.axes(i, j));
  }
  return lowest;
}

/// A box in whole numbers: center and half edges times 4^shift, directions times 2^shift.
template <int Dim>
struct WholeBox {
  IntegerVector<Dim> center;
  std::array<IntegerVector<Dim>, Dim> half_edges, directions;

  WholeBox(const Obb<double, Dim>& box, int shift) {
    for (int k = 0; k < Dim; ++k) {
      const auto at = static_cast<std::size_t>(k);
      center[at] = scaled(box.center[k], 2 * shift);
      const Integer half = scaled(box.half_extents[k], shift);
      for (int row = 0; row < Dim; ++row) {
        directions[at][row] = scaled(box.axes(row, k), shift);
        half_edges[at][row] = half * directions[at][row];
      }
    }
  }

  [[nodiscard]] std::vector<IntegerVector<Dim>> corners() const {
    std::vector<IntegerVector<Dim>> all{center};
    for (const auto& edge : half_edges) {
      std::vector<IntegerVector<Dim>> next;
      for (const auto& corner : all)
        for (const int sign : {-1, 1}) {
          next.push_back(corner);
          for (std::size_t i = 0; i < Dim; ++i) next.back()[i] += sign * edge[i];
        }
      all = next;
    }
    return all;
  }
};

template <int Dim>
bool is_separating(const IntegerVector<Dim>& axis, const std::vector<IntegerVector<Dim>>& a,
                   const std::vector<IntegerVector<Dim>>& b) {
  const auto range = [&](const std::vector<IntegerVector<Dim>>& corners) {
    std::array<Integer, 2> least_and_greatest;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      Integer projection = 0;
      for (std::size_t i = 0; i < Dim; ++i) projection += axis[i] * corners[c][i];
      if (c == 0 || projection < least_and_greatest[0]) least_and_greatest[0] = projection;
      if (c == 0 || projection > least_and_greatest[1]) least_and_greatest[1] = projection;
    }
    return least_and_greatest;
  };
  const auto x = range(a), y = range(b);
  return x[0] > y[1] || y[0] > x[1];
}

}  // namespace

template <int Dim>
bool overlap_by_corners(const Obb<double, Dim>& a, const Obb<double, Dim>& b) {
  const int shift = -std::min(lowest_bit(a), lowest_bit(b));
  const WholeBox<Dim> first(a, shift), second(b, shift);
  const auto corners_a = first.corners(), corners_b = second.corners();
  std::vector<IntegerVector<Dim>> edges(first.directions.begin(), first.directions.end());
  edges.insert(edges.end(), second.directions.begin(), second.directions.end());
  for (std::size_t p = 0; p < edges.size(); ++p) {
    if constexpr (Dim == 2) {
      if (is_separating<2>({-edges[p][1], edges[p][0]}, corners_a, corners_b)) return false;
    } else {
      for (std::size_t q = p + 1; q < edges.size(); ++q) {
        const auto &u = edges[p], &v = edges[q];
        const IntegerVector<3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        if (is_separating<3>(normal, corners_a, corners_b)) return false;
      }
    }
  }
  return true;
}

// The first phase of the simplex method with Bland's rule on sum_k x_k g_k = target, x_k + y_k = 2, all at least 0,
// where x = s + 1.
template <int Dim>
bool overlap_by_simplex(const Obb<double, Dim>& a, const Obb<double, Dim>& b) {
  constexpr std::size_t kDim = Dim, kEdges = 2 * kDim, kRows = kDim + kEdges, kColumns = 2 * kEdges;
  const auto exact = [](double value) { return Rational(value); };
  std::array<std::array<Rational, kColumns + 1>, kRows> table;
  std::array<std::size_t, kRows> basis;
  for (std::size_t row = 0; row < kDim; ++row) {
    const int r = static_cast<int>(row);
    Rational target = exact(b.center[r]) - exact(a.center[r]);
    for (int k = 0; k < Dim; ++k) {
      table[row][k] = exact(a.half_extents[k]) * exact(a.axes(r, k));
      table[row][kDim + k] = exact(b.half_extents[k]) * exact(b.axes(r, k));
    }
    for (std::size_t k = 0; k < kEdges; ++k) target += table[row][k];
    table[row][kColumns] = target;
    if (target < 0)
      for (auto& entry : table[row]) entry = -entry;
    basis[row] = kColumns + 1 + row;  // artificial
  }
  for (std::size_t k = 0; k < kEdges; ++k) {
    const std::size_t row = kDim + k;
    table[row][k] = table[row][kEdges + k] = 1;
    table[row][kColumns] = 2;
    basis[row] = kEdges + k;
  }
  for (;;) {
    const auto artificial = [&](std::size_t row) { return basis[row] > kColumns; };
    std::size_t column = 0;
    for (; column < kColumns; ++column) {  // Bland: the first whose entering lessens the artificial ones' sum
      Rational gain = 0;
      for (std::size_t row = 0; row < kRows; ++row)
        if (artificial(row)) gain += table[row][column];
      if (gain > 0) break;
    }
    if (column == kColumns) {
      for (std::size_t row = 0; row < kRows; ++row)
        if (artificial(row) && table[row][kColumns] != 0) return false;
      return true;
    }
    std::size_t leaving = kRows;
    for (std::size_t row = 0; row < kRows; ++row) {
      if (table[row][column] <= 0) continue;
      if (leaving == kRows) {
        leaving = row;
        continue;
      }
      const Rational here = table[row][kColumns] * table[leaving][column];
      const Rational best = table[leaving][kColumns] * table[row][column];
      if (here < best || (here == best && basis[row] < basis[leaving])) leaving = row;
    }
    const Rational pivot = table[leaving][column];
    for (auto& entry : table[leaving])
      if (entry != 0) entry /= pivot;
    for (std::size_t row = 0; row < kRows; ++row) {
      if (row == leaving || table[row][column] == 0) continue;
      const Rational factor = table[row][column];
      for (std::size_t k = 0; k <= kColumns; ++k)
        if (table[leaving][k] != 0) table[row][k] -= factor * table[leaving][k];
    }
    basis[leaving] = column;
  }
}

template bool overlap_by_corners(const Obb<double, 2>&, const Obb<double, 2>&);
template bool overlap_by_corners(const Obb<double, 3>&, const Obb<double, 3>&);
template bool overlap_by_simplex(const Obb<double, 2>&, const Obb<double, 2>&);
template bool overlap_by_simplex(const Obb<double, 3>&, const Obb<double, 3>&);

}  // namespace snug::exact
