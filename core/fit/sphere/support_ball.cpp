#include "fit/sphere/support_ball.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "geometry/sphere.hpp"
#include "geometry/tolerance.hpp"
#include "number/bits.hpp"
#include "number/tuple.hpp"

namespace snug::fit {
namespace {

using Wide = DoubleDouble;

/// Solves the symmetric positive semidefinite system gram * x = right, n <= 3, by elimination with the largest
/// pivot first. Entries are scaled to 1 or below. False where a pivot counts as zero.
template <int N>
bool solve(std::array<std::array<Wide, N>, N>& gram, std::array<Wide, N>& right, int n) {
  std::array<int, N> order{};
  for (int i = 0; i < n; ++i) order[i] = i;
  const auto at = [&](int row, int column) -> Wide& { return gram[order[row]][order[column]]; };
  const auto b = [&](int row) -> Wide& { return right[order[row]]; };

  for (int k = 0; k < n; ++k) {
    int largest = k;
    for (int i = k + 1; i < n; ++i)
      if (at(largest, largest) < at(i, i)) largest = i;
    std::swap(order[k], order[largest]);
    if (!(at(k, k).high > tolerance::kDependentPivot)) return false;
    at(k, k) = Wide(1) / at(k, k);  // a division takes as long as many multiplications
    for (int i = k + 1; i < n; ++i) {
      const Wide factor = at(i, k) * at(k, k);
      for (int j = k + 1; j < n; ++j) at(i, j) -= factor * at(k, j);
      b(i) -= factor * b(k);
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int j = k + 1; j < n; ++j) b(k) -= at(k, j) * b(j);
    b(k) *= at(k, k);
  }
  return true;
}

/// value * 2^exponent, both parts exactly.
Wide scaled(Wide value, int exponent) {
  if (exponent < -1022 || exponent > 1023) return {std::ldexp(value.high, exponent), std::ldexp(value.low, exponent)};
  const double power = double_of(static_cast<std::uint64_t>(exponent + 1023) << 52);  // ldexp is a call, and slow
  return {value.high * power, value.low * power};
}

/// The edges from the first support point to the others, scaled by a power of two to a largest coordinate near 1.
template <class Scalar, int Dim>
struct Edges {
  std::array<Tuple<Wide, Dim>, Dim> edge;
  int exponent = 0;

  Edges(PointSpan<Scalar, Dim> points, const Support& support) {
    const Vector<double, Dim> base = points[support[0]].template cast<double>();
    double largest = 0;
    for (int k = 1; k < support.size(); ++k) {
      const Vector<double, Dim> p = points[support[k]].template cast<double>();
      for (int i = 0; i < Dim; ++i) {
        const Wide difference = Wide::sum(p[i], -base[i]);
        edge[k - 1][i] = difference;
        largest = std::max(largest, std::abs(difference.high));
      }
    }
    exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
    for (int k = 1; k < support.size(); ++k)
      for (Wide& coordinate : edge[k - 1]) coordinate = scaled(coordinate, -exponent);
  }
};

}  // namespace

template <int Dim>
bool smaller(const SupportBall<Dim>& a, const SupportBall<Dim>& b) {
  const int apart = a.exponent - b.exponent;
  if (a.scaled_square.high == 0 || b.scaled_square.high == 0 || std::abs(apart) > 200)
    return a.scaled_square.high == 0 || b.scaled_square.high == 0 ? a.scaled_square < b.scaled_square : apart < 0;
  return scaled(a.scaled_square, 2 * apart) < b.scaled_square;
}

template <class Scalar, int Dim>
std::optional<SupportBall<Dim>> ball_through(PointSpan<Scalar, Dim> points, const Support& support) {
  const int n = support.size() - 1;
  const Edges<Scalar, Dim> edges(points, support);
  const auto edge = [&](int i) -> const Tuple<Wide, Dim>& { return edges.edge[i]; };

  std::array<std::array<Wide, Dim>, Dim> gram{};
  std::array<Wide, Dim> weight{};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Wide entry = dot(edge(i), edge(j));
      gram[i][j] = entry;
      gram[j][i] = entry;
    }
    weight[i] = scaled(gram[i][i], -1);
  }
  if (!solve<Dim>(gram, weight, n)) return std::nullopt;

  Tuple<Wide, Dim> to_center{};
  Wide first = 1.0;
  SupportBall<Dim> ball{.support = support};
  for (int i = 0; i < n; ++i) {
    const Wide w = weight[i];
    first -= w;
    ball.weights[i + 1] = w.value();
    for (std::size_t axis = 0; axis < Dim; ++axis) to_center[axis] += w * edge(i)[axis];
  }
  ball.weights[0] = first.value();
  ball.exponent = edges.exponent;
  ball.scaled_square = dot(to_center, to_center);
  ball.radius = std::ldexp(std::sqrt(ball.scaled_square.value()), edges.exponent);
  const Vector<double, Dim> base = points[support[0]].template cast<double>();
  for (int axis = 0; axis < Dim; ++axis)
    ball.center[axis] = (scaled(to_center[axis], edges.exponent) + Wide(base[axis])).value();
  return ball;
}

namespace {

/// Whether it is certainly the smallest ball around the other points too, so that no further subset needs to be tried.
template <class Scalar, int Dim>
bool surely_smallest(PointSpan<Scalar, Dim> points, const SupportBall<Dim>& ball, const Support& others) {
  for (int i = 0; i < ball.support.size(); ++i)
    if (!(ball.weights[i] > tolerance::kBeyondDoubt)) return false;
  return std::all_of(others.begin(), others.end(), [&](Index i) {
    if (ball.support.contains(i)) return true;
    const double distance = scaled_norm<double, Dim>(points[i].template cast<double>() - ball.center);
    return distance < ball.radius * (1 - tolerance::kBeyondDoubt);
  });
}

}  // namespace

template <class Scalar, int Dim>
SupportBall<Dim> smallest_ball_with(PointSpan<Scalar, Dim> points, Index on_boundary, const Support& others) {
  SupportBall<Dim> best = *ball_through(points, Support{on_boundary});
  for (int size = std::min(Dim, others.size()); size > 0; --size)
    for (unsigned subset = 1; subset < (1u << static_cast<unsigned>(others.size())); ++subset) {
      if (std::popcount(subset) != size) continue;
      Support support{on_boundary};
      for (int i = 0; i < others.size(); ++i)
        if ((subset >> static_cast<unsigned>(i) & 1u) != 0) support.add(others[i]);
      const auto ball = ball_through(points, support);
      if (!ball || !ball->center_in_hull()) continue;
      if (surely_smallest(points, *ball, others)) return *ball;
      const bool as_large_with_fewer = !smaller(*ball, best) && ball->support.size() < best.support.size();
      if (smaller(best, *ball) || as_large_with_fewer) best = *ball;
    }
  return best;
}

template bool smaller(const SupportBall<2>&, const SupportBall<2>&);
template bool smaller(const SupportBall<3>&, const SupportBall<3>&);

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template std::optional<SupportBall<Dim>> ball_through(PointSpan<Scalar, Dim>, const Support&);                       \
  template SupportBall<Dim> smallest_ball_with(PointSpan<Scalar, Dim>, Index, const Support&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug::fit
