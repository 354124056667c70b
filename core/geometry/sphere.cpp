#include "geometry/sphere.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/exact_sum.hpp"
#include "geometry/tolerance.hpp"

namespace snug {
namespace {

/// Squares outside this range may have lost digits to underflow or overflow.
template <class Scalar>
bool square_is_sound(Scalar square) {
  constexpr Scalar kSmall = std::numeric_limits<Scalar>::min() / tolerance::kRoundoff<Scalar> * 16;
  constexpr Scalar kLarge = std::numeric_limits<Scalar>::max() / 16;
  return square > kSmall && square < kLarge;
}

constexpr Index kBlock = 2048;
// Up to this many points near the boundary are decided exactly; with more, the radius is widened by its error bound.
constexpr Index kExactCandidates = 4096;

template <class Scalar>
struct Farthest {
  Scalar square = 0;
  Index point = 0;
  std::vector<Scalar> of_block;
};

template <class Scalar, int Dim>
Farthest<Scalar> farthest(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points) {
  Farthest<Scalar> result;
  result.of_block.reserve(static_cast<std::size_t>(points.size() / kBlock + 1));
  for (Index begin = 0; begin < points.size(); begin += kBlock) {
    const Index end = std::min(points.size(), begin + kBlock);
    Scalar most = -1;
    Index at = begin;
    for (Index i = begin; i < end; ++i) {
      const Scalar square = (points[i] - center).squaredNorm();
      if (square > most) {
        most = square;
        at = i;
      }
    }
    result.of_block.push_back(most);
    if (most > result.square) {
      result.square = most;
      result.point = at;
    }
  }
  return result;
}

/// Widens the radius until each of the points given holds; calls are few, for it starts within a few ulps.
template <class Scalar, int Dim>
void widen_to_hold(Sphere<Scalar, Dim>& sphere, const Vector<Scalar, Dim>& point) {
  while (side_of_sphere(point, sphere) > 0)
    sphere.radius = std::nextafter(sphere.radius, std::numeric_limits<Scalar>::max());
}

template <class Scalar, int Dim>
EnclosingRadius<Scalar> enclosing_radius_by_norms(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points) {
  EnclosingRadius<Scalar> result;
  for (Index i = 0; i < points.size(); ++i) {
    const Scalar norm = scaled_norm<Scalar, Dim>(points[i] - center);
    if (norm > result.radius) result = {norm, i};
  }
  Sphere<Scalar, Dim> sphere{center, result.radius};
  for (const auto& p : points) widen_to_hold(sphere, p);
  return {sphere.radius, result.farthest};
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
    const double doubt = tolerance::kSquaredDistance<double> * std::max(square, radius_square);
    if (square - radius_square > doubt) return 1;
    if (radius_square - square > doubt) return -1;
  }
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
EnclosingRadius<Scalar> enclosing_radius(const Vector<Scalar, Dim>& center, PointSpan<Scalar, Dim> points) {
  const Farthest<Scalar> far = farthest(center, points);
  if (!square_is_sound(far.square)) return enclosing_radius_by_norms(center, points);

  constexpr Scalar kBound = tolerance::kSquaredDistance<Scalar>;
  const Scalar threshold = far.square * (1 - 2 * kBound);
  Sphere<Scalar, Dim> sphere{center, std::sqrt(far.square)};
  Index candidates = 0;
  for (std::size_t block = 0; block < far.of_block.size(); ++block) {
    if (far.of_block[block] < threshold) continue;
    const Index begin = static_cast<Index>(block) * kBlock;
    const Index end = std::min(points.size(), begin + kBlock);
    for (Index i = begin; i < end; ++i) {
      if ((points[i] - center).squaredNorm() < threshold) continue;
      if (++candidates > kExactCandidates) return {std::sqrt(far.square * (1 + 2 * kBound)), far.point};
      widen_to_hold(sphere, points[i]);
    }
  }
  return {sphere.radius, far.point};
}

#define SNUG_INSTANTIATE(Scalar, Dim) \
  template EnclosingRadius<Scalar> enclosing_radius(const Vector<Scalar, Dim>&, PointSpan<Scalar, Dim>);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug
