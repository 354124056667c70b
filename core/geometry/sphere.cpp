#include "geometry/sphere.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/tolerance.hpp"
#include "number/double_double.hpp"
#include "number/exact_sum.hpp"
#include "number/exact_tally.hpp"

namespace snug {
namespace {

/// Squares outside this range may have lost digits to underflow or overflow.
template <class Scalar>
bool square_is_sound(Scalar square) {
  constexpr Scalar kSmall = std::numeric_limits<Scalar>::min() / tolerance::kRoundoff<Scalar> * 16;
  constexpr Scalar kLarge = std::numeric_limits<Scalar>::max() / 16;
  return square > kSmall && square < kLarge;
}

bool wide_is_sound(double square) {
  return square > tolerance::kSoundWideSquare && square < 1 / tolerance::kSoundWideSquare;
}

/// The side in twice a double's digits; none if that is in doubt. What each step rounds away is summed
/// separately.
inline int side_in_double_double(const double* point, const double* center, double radius, int dim) noexcept {
  const DoubleDouble square = DoubleDouble::product(radius, radius);
  double sum = -square.high, rest = -square.low;
  for (int i = 0; i < dim; ++i) {
    const DoubleDouble d = DoubleDouble::sum(point[i], -center[i]);
    const DoubleDouble p = DoubleDouble::product(d.high, d.high);
    const DoubleDouble s = DoubleDouble::sum(sum, p.high);
    sum = s.high;
    rest += s.low + (p.low + 2 * d.high * d.low);
  }
  const double gap = sum + rest, error_bound = tolerance::kWideSquaredDistance * square.high;
  if (gap > error_bound) return 1;
  return gap < -error_bound ? -1 : 0;
}

/// A power of two near the square root.
Index block_of(Index points) {
  std::int64_t block = 16;
  while (block * block < points) block *= 2;
  return static_cast<Index>(block);
}

// Up to this many points near the boundary are decided exactly; beyond, the radius is widened by its error bound.
constexpr Index kExactCandidates = 4096;

/// Widens the radius until the ball contains the given points, in few steps, as it starts within a few ulps.
template <class Scalar, int Dim>
void widen_to_hold(Sphere<Scalar, Dim>& sphere, const Vector<Scalar, Dim>& point) {
  while (side_of_sphere(point, sphere) > 0)
    sphere.radius = std::nextafter(sphere.radius, std::numeric_limits<Scalar>::max());
}

template <class Scalar, int Dim>
Scalar enclosing_radius_by_norms(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points) {
  Sphere<Scalar, Dim> sphere{center, 0};
  for (const auto& p : points) sphere.radius = std::max(sphere.radius, scaled_norm<Scalar, Dim>(p - center));
  for (const auto& p : points) widen_to_hold(sphere, p);
  return sphere.radius;
}

}  // namespace

int side_of_sphere(const double* point, const double* center, double radius, int dim) noexcept {
  double square = 0;
  for (int i = 0; i < dim; ++i) {
    const double d = point[i] - center[i];
    square += d * d;
  }
  const double radius_square = radius * radius;
  if (square_is_sound(square) && square_is_sound(radius_square)) {
    const double error_bound = tolerance::kSquaredDistance<double> * std::max(square, radius_square);
    if (square - radius_square > error_bound) return 1;
    if (radius_square - square > error_bound) return -1;
    if (wide_is_sound(square) && wide_is_sound(radius_square))
      if (const int side = side_in_double_double(point, center, radius, dim); side != 0) return side;
  }
  ++exact_decisions;
  ExactSum sum;
  for (int i = 0; i < dim; ++i) {
    sum.add_product(point[i], point[i]);
    sum.add_product(-2 * point[i], center[i]);
    sum.add_product(center[i], center[i]);
  }
  sum.add_product(-radius, radius);
  return sum.sign();
}

template <class Scalar, int Dim>
FarthestPoints<Scalar> farthest_points(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points) {
  FarthestPoints<Scalar> result{.block = block_of(points.size())};
  result.of_block.reserve(points.size() / result.block + 1);
  for (Index begin = 0; begin < points.size(); begin += result.block) {
    const Index end = begin + std::min(points.size() - begin, result.block);
    typename FarthestPoints<Scalar>::Far most{-1, begin};
    for (Index i = begin; i < end; ++i) {
      const Scalar square = (points[i] - center).squaredNorm();
      if (square > most.square) most = {square, i};
    }
    result.of_block.push_back(most);
    if (most.square > result.overall.square) result.overall = most;
  }
  return result;
}

template <class Scalar, int Dim>
Scalar enclosing_radius(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points,
                        const FarthestPoints<Scalar>& far) {
  const Scalar most = far.overall.square;
  if (!square_is_sound(most)) return enclosing_radius_by_norms(center, points);

  constexpr Scalar kBound = tolerance::kSquaredDistance<Scalar>;
  const Scalar threshold = most * (1 - 2 * kBound);
  Sphere<Scalar, Dim> sphere{center, std::sqrt(most)};
  const Vector<double, Dim> c = center.template cast<double>();
  const bool wide = wide_is_sound(static_cast<double>(most));  // so near the boundary, plain doubles decide nothing
  Index candidates = 0;
  Index begin = 0;
  for (const auto& block : far.of_block) {
    const Index end = begin + std::min(points.size() - begin, far.block);
    for (Index i = begin; i < end && block.square >= threshold; ++i) {
      if ((points[i] - center).squaredNorm() < threshold) continue;
      if (++candidates > kExactCandidates) return std::sqrt(most * (1 + 2 * kBound));
      const Vector<double, Dim> p = points[i].template cast<double>();
      const bool held = wide && side_in_double_double(p.data(), c.data(), static_cast<double>(sphere.radius), Dim) < 0;
      if (!held) widen_to_hold(sphere, points[i]);
    }
    begin = end;
  }
  return sphere.radius;
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template FarthestPoints<Scalar> farthest_points(const Vector<Scalar, Dim>&, PointSpan<Scalar, Dim>);                 \
  template Scalar enclosing_radius(const Vector<Scalar, Dim>&, PointSpan<Scalar, Dim>, const FarthestPoints<Scalar>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug
