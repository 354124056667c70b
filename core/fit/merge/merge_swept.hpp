// What merging capsules and lozenges share: both are hulls of balls, so a convex volume need only contain the balls.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "fit/swept/swept_radius.hpp"
#include "number/outward.hpp"
#include "number/power_of_two.hpp"
#include "query/contain/contains.hpp"

namespace snug::fit {

template <int Dim>
struct BallIn {
  Vector<double, Dim> center;
  double radius;
};
template <int Dim>
using Balls = std::vector<BallIn<Dim>>;

template <class Scalar, int Dim>
[[nodiscard]] Balls<Dim> balls_of(const Capsule<Scalar, Dim>& capsule) {
  const auto radius = static_cast<double>(capsule.radius);
  return {{capsule.a.template cast<double>(), radius}, {capsule.b.template cast<double>(), radius}};
}

/// The balls at the vertices of the core. A vertex is not stored, but is a sum of up to three vectors, so each ball is
/// enlarged by the rounding error of that sum.
template <class Scalar, int Dim>
[[nodiscard]] Balls<Dim> balls_of(const Lozenge<Scalar, Dim>& lozenge) {
  const Vector<double, Dim> o = lozenge.origin.template cast<double>();
  const Vector<double, Dim> e = lozenge.edges[0].template cast<double>(), f = lozenge.edges[1].template cast<double>();
  const auto radius = static_cast<double>(lozenge.radius);
  if (e.isZero(0) && f.isZero(0)) return {{o, radius}};
  const double size = o.template lpNorm<1>() + e.template lpNorm<1>() + f.template lpNorm<1>();
  const double wider = sum_up<double>(radius, tolerance::kLozengeCorner * size);
  if (f.isZero(0)) return {{o, radius}, {o + e, wider}};
  if (e.isZero(0)) return {{o, radius}, {o + f, wider}};
  return {{o, radius}, {o + e, wider}, {o + f, wider}, {o + (e + f), wider}};
}

template <class Scalar, int Dim>
[[nodiscard]] Capsule<double, Dim> in_double(const Capsule<Scalar, Dim>& capsule) {
  return {capsule.a.template cast<double>(), capsule.b.template cast<double>(), static_cast<double>(capsule.radius)};
}
template <class Scalar, int Dim>
[[nodiscard]] Lozenge<double, Dim> in_double(const Lozenge<Scalar, Dim>& lozenge) {
  return {lozenge.origin.template cast<double>(),
          {lozenge.edges[0].template cast<double>(), lozenge.edges[1].template cast<double>()},
          static_cast<double>(lozenge.radius)};
}

/// Whether the ball is certainly inside: its centre is within the difference of the radii, rounded down, of the core.
template <class VolumeType, int Dim>
[[nodiscard]] bool holds(const VolumeType& volume, const Balls<Dim>& balls) {
  auto inner = in_double(volume);
  const double radius = inner.radius;
  for (const BallIn<Dim>& ball : balls) {
    inner.radius = sum_down<double>(radius, -ball.radius);
    if (inner.radius < 0 || !query::contains(inner, ball.center)) return false;
  }
  return true;
}

/// Sets the radius to the least, but for a few roundings, with which the volume contains the balls.
template <class VolumeType, int Dim>
void widen_to_hold(VolumeType& volume, const Balls<Dim>& balls) {
  using Scalar = decltype(volume.radius);
  const ScaledCore<Dim> core(volume);
  double most = 0;
  for (const BallIn<Dim>& ball : balls) most = std::max(most, core.distance(ball.center) + ball.radius);
  volume.radius = static_cast<Scalar>(most);
  // The steps double. They start at a length that is negligible beside the rounding of the core's coordinates.
  const auto least_step =
      static_cast<Scalar>(core.size() * tolerance::kRoundoff<Scalar> * tolerance::kRoundoff<Scalar>);
  Scalar step = std::max(std::nextafter(volume.radius, std::numeric_limits<Scalar>::max()) - volume.radius, least_step);
  for (; !holds(volume, balls); step *= 2) volume.radius += step;
}

/// The balls of both, relative to a point of one and scaled by a power of two, so that no square over- or underflows.
template <int Dim>
struct LocalBalls {
  Vector<double, Dim> origin;
  double scale = 1;
  Balls<Dim> balls;

  explicit LocalBalls(const Balls<Dim>& given) : origin(given.front().center), balls(given) {
    double largest = 0;
    for (BallIn<Dim>& ball : balls) {
      ball.center -= origin;
      largest = std::max({largest, ball.center.cwiseAbs().maxCoeff(), ball.radius});
    }
    scale = to_unit_size(largest);
    for (BallIn<Dim>& ball : balls) {
      ball.center *= scale;
      ball.radius *= scale;
    }
  }
  [[nodiscard]] Vector<double, Dim> to_scene(const Vector<double, Dim>& local) const { return origin + local / scale; }
};

/// Returns the smallest of several volumes, the first among equals; none if there are none.
template <class VolumeType, class Maker, class Choices>
[[nodiscard]] std::optional<VolumeType> least_of(const Choices& choices, Maker&& make) {
  std::optional<VolumeType> least;
  for (const auto& choice : choices) {
    const std::optional<VolumeType> volume = make(choice);
    if (volume && (!least || measure(*volume) < measure(*least))) least = volume;
  }
  return least;
}

}  // namespace snug::fit
